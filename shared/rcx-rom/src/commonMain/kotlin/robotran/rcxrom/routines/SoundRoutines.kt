package robotran.rcxrom.routines

import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.sound.Sound
import robotran.rcxrom.sound.Speaker
import robotran.rcxrom.sound.SystemSounds
import robotran.rcxrom.sound.ToneTimer

/** The routines that play sounds and report whether any are playing. */
internal class SoundRoutines(
    private val memory: RcxMemory,
    private val speaker: Speaker,
    private val messages: BrickMessages,
) {
    val routines: Map<Int, RomRoutine> = mapOf(
        RomAddress.PLAY_SYSTEM_SOUND to ::playSystemSound,
        RomAddress.PLAY_VIEW_BUTTON_SOUND to ::playViewButtonSound,
        RomAddress.READ_SOUND_PLAYING to ::readPlaying,
    )

    /** Queues a tone of [hertz]. [duration] is in hundredths of a second; only its low byte counts. */
    fun queueTone(hertz: Int, duration: Int): RomEffect {
        val sound = ToneTimer.sound(hertz, duration % DURATIONS)
        return queue(sound, if (sound.kind == Sound.PAUSE) name(sound) else messages.tone(hertz, milliseconds(sound)))
    }

    fun queueSystemSound(number: Int): RomEffect = queue(Sound.system(number), systemSoundName(number))

    fun queue(sound: Sound): RomEffect = queue(sound, name(sound))

    /** Plays [sound] at once and discards all others. */
    fun playNow(sound: Sound): RomEffect = playNow(sound, name(sound))

    private fun playSystemSound(arguments: List<Int>): RomEffect {
        val (code, number) = arguments
        return when (code) {
            RomCode.SOUND_NOW -> playNow(Sound.system(number), systemSoundName(number))
            RomCode.SOUND_QUEUED -> queueSystemSound(number)
            else -> refused(messages.unknownCode(code))
        }
    }

    private fun playViewButtonSound(arguments: List<Int>): RomEffect = if (arguments[0] == RomCode.VIEW_BUTTON_SOUND) {
        playNow(Sound.system(SystemSounds.TWO_BEEPS))
    } else {
        refused(messages.unknownCode(arguments[0]))
    }

    private fun readPlaying(arguments: List<Int>): RomEffect {
        val (code, pointer) = arguments
        if (code != RomCode.SOUND_PLAYING) return refused(messages.unknownCode(code))
        val playing = memory.readByte(Speaker.PLAYING_FLAG)
        memory.writeByte(pointer, playing)
        return RomEffect(messages.soundPlaying(playing != 0))
    }

    private fun queue(sound: Sound, name: String) =
        RomEffect(if (speaker.enqueue(sound)) messages.queued(name) else messages.dropped(name))

    private fun playNow(sound: Sound, name: String): RomEffect {
        speaker.playNow(sound)
        return RomEffect(messages.playedAtOnce(name))
    }

    private fun name(sound: Sound): String = when (sound.kind) {
        Sound.PAUSE -> messages.pause(milliseconds(sound))
        Sound.SYSTEM_SOUND -> systemSoundName(sound.value)

        else -> when (val hertz = ToneTimer.hertz(sound.kind, sound.control)) {
            null -> messages.pause(milliseconds(sound))
            else -> messages.tone((hertz + HALF).toInt(), milliseconds(sound))
        }
    }

    private fun milliseconds(sound: Sound): Int = sound.value * Speaker.LOOK_MILLISECONDS

    private fun systemSoundName(number: Int): String =
        messages.systemSound(number.toShort().toInt(), SystemSounds.played(number))

    private companion object {
        /** The ROM stores the duration in a byte. */
        const val DURATIONS = 256
        const val HALF = 0.5
    }
}

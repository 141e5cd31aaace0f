package robotran.rom

/** The routines that play sounds and tell whether any are played. */
internal class SoundRoutines(
    private val memory: RcxMemory,
    private val speaker: Speaker,
) {
    val routines: Map<Int, RomRoutine> = mapOf(
        RomAddress.PLAY_SYSTEM_SOUND to ::playSystemSound,
        RomAddress.PLAY_TONE to ::playTone,
        RomAddress.READ_SOUND_PLAYING to ::readPlaying,
    )

    private fun playSystemSound(arguments: List<Int>): RomEffect {
        val (code, number) = arguments
        return when (code) {
            RomCode.SOUND_NOW -> playSystemSoundNow(number)
            RomCode.SOUND_QUEUED -> queueSystemSound(number)
            else -> unknownCode(code)
        }
    }

    private fun playTone(arguments: List<Int>): RomEffect {
        val (code, hertz, last) = arguments
        return when (code) {
            RomCode.TONE -> queueTone(hertz, milliseconds = last % DURATIONS * Speaker.LOOK_MILLISECONDS)
            RomCode.TONE_SYSTEM_SOUND -> queueSystemSound(last)
            RomCode.TONE_DATA_POINTER -> RomEffect("nothing happens, receiving data is not modelled", RomOutcome.NOT_MODELLED)
            else -> unknownCode(code)
        }
    }

    private fun readPlaying(arguments: List<Int>): RomEffect {
        val (_, pointer) = arguments
        val playing = memory.readByte(Speaker.PLAYING_FLAG)
        memory.writeByte(pointer, playing)
        return RomEffect(if (playing == 0) "no sound is playing" else "a sound is playing")
    }

    private fun playSystemSoundNow(number: Int): RomEffect {
        speaker.playNow(SystemSounds.sound(number))
        return RomEffect("play ${systemSoundName(number)} at once")
    }

    private fun queueTone(hertz: Int, milliseconds: Int): RomEffect {
        val real = ToneTimer.realHertz(hertz)
        val name = if (real == null) "pause of $milliseconds ms" else "tone of $hertz Hz for $milliseconds ms"
        return queue(listOf(Note(real, milliseconds)), name)
    }

    private fun queueSystemSound(number: Int) = queue(SystemSounds.sound(number), systemSoundName(number))

    private fun queue(sound: Sound, name: String): RomEffect =
        RomEffect(if (speaker.enqueue(sound)) "queue $name" else "drop $name, for the sound queue is full")

    private fun systemSoundName(number: Int): String {
        val remark = if (SystemSounds.played(number) == number) "" else ", for there is no ${number.toShort()}"
        return "system sound ${SystemSounds.played(number)} (${SystemSounds.name(number)}$remark)"
    }

    private companion object {
        /** The ROM keeps the duration in a byte. */
        const val DURATIONS = 256
    }
}

package robotran.rcxrom

import robotran.brick.sound.SoundEvent
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.log.RomLogEntry
import robotran.rcxrom.routines.Hardware
import robotran.rcxrom.sound.Sound
import robotran.rcxrom.sound.ToneTimer

/** The source line of test calls. */
internal const val TEST_LINE = 7

/** The address for results of test calls. */
internal const val RESULT = 0x9000

/** Calls a routine and returns its log entry. */
internal fun Hardware.call(address: Int, vararg arguments: Int): RomLogEntry {
    rom.call(RomCall(address, arguments.map { it and 0xFFFF }), TEST_LINE)
    return log.entries.last() as RomLogEntry
}

internal fun Hardware.tick(milliseconds: Int) = repeat(milliseconds) { tick() }

/** The tones started so far. */
internal fun Hardware.tones(): List<SoundEvent.Tone> = speaker.track.since(0).filterIsInstance<SoundEvent.Tone>()

internal fun RcxBrick.tones(): List<SoundEvent.Tone> = sounds.since(0).filterIsInstance<SoundEvent.Tone>()

/** The real frequency of the tone routine for [hertz]; null outside the timer's range, which is silent. */
internal fun realHertz(hertz: Int): Double? = ToneTimer.sound(hertz, duration = 1).let {
    if (it.kind == Sound.PAUSE) {
        null
    } else {
        ToneTimer.hertz(it.kind, it.control)
    }
}

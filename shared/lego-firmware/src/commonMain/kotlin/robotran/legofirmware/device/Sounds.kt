package robotran.legofirmware.device

import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCode

/** Sounds of a program: the ROM plays them one after the other while the program goes on. */
internal class Sounds(private val calls: RomCalls) {
    /** Whether the program has switched sounds off; those that it plays meanwhile are lost. */
    var isMuted = false

    fun play(systemSound: Int) {
        if (!isMuted) calls.call(RomAddress.PLAY_SYSTEM_SOUND, RomCode.SOUND_QUEUED, systemSound)
    }

    /** @param duration in 10 ms, 0..255. */
    fun tone(hertz: Int, duration: Int) {
        if (!isMuted) calls.call(RomAddress.PLAY_TONE, RomCode.TONE, hertz, duration)
    }

    /** Ends all sounds. The ROM does so when it gets a sound to play at once: here, the shortest pause. */
    fun clear() = calls.call(RomAddress.CONTROL_OUTPUT, RomCode.OUTPUT_SOUND_NOW, PAUSE, 1, 0)

    private companion object {
        /** The ROM's kind of a sound that is none. */
        const val PAUSE = 0
    }
}

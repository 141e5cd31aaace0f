package robotran.desktop.sound

import robotran.ui.sound.SampleFeeder
import robotran.ui.sound.SampleLine
import robotran.workshop.sound.LoudSpeaker
import robotran.workshop.sound.ToneWave
import javax.sound.sampled.AudioFormat
import javax.sound.sampled.AudioSystem
import javax.sound.sampled.DataLine
import javax.sound.sampled.LineUnavailableException
import javax.sound.sampled.SourceDataLine

/**
 * The loudspeaker of this computer. The sound card is looked for when the first tone is to be heard, and nobody waits
 * for it.
 */
internal fun soundCardSpeaker(): LoudSpeaker = SampleFeeder { openSoundCard(::findLine) }

/** Sixteen bits, one channel, the low byte first. */
internal val FORMAT = AudioFormat(ToneWave.SAMPLE_RATE.toFloat(), Short.SIZE_BITS, 1, true, false)

/**
 * A line of [FORMAT] to the sound card.
 *
 * @param find answers the line as Java's sound system has it; may throw what that throws where there is no sound card,
 * or another program keeps it for itself.
 * @return null if there is none.
 */
internal fun openSoundCard(find: () -> SourceDataLine): SampleLine? = try {
    val line = find()
    line.open(FORMAT, SampleLine.BUFFER_BYTES)
    line.start()
    SoundCardLine(line)
} catch (_: LineUnavailableException) {
    null
} catch (_: IllegalArgumentException) {
    null
} catch (_: SecurityException) {
    null
}

private fun findLine(): SourceDataLine =
    AudioSystem.getLine(DataLine.Info(SourceDataLine::class.java, FORMAT)) as SourceDataLine

/** [line] is open and started. */
private class SoundCardLine(private val line: SourceDataLine) : SampleLine {
    override fun write(samples: ByteArray) {
        line.write(samples, 0, samples.size)
    }

    override fun discard() = line.flush()

    override fun close() = line.close()
}

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

/** The computer's audio output. The sound card is opened in the background for the first tone. */
internal fun soundCardSpeaker(): LoudSpeaker = SampleFeeder { openSoundCard(::findLine) }

/** 16-bit stereo, little-endian. */
internal val FORMAT =
    AudioFormat(ToneWave.SAMPLE_RATE.toFloat(), Short.SIZE_BITS, ToneWave.CHANNELS, true, false)

/**
 * Opens a line of [FORMAT] to the sound card.
 *
 * @param find returns the line from Java's sound system; may throw its exceptions if there is no sound card or another
 * program blocks it.
 * @return null if no line is available.
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

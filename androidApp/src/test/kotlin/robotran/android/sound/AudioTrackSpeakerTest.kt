package robotran.android.sound

import android.media.AudioFormat
import org.junit.After
import org.junit.Assert.assertEquals
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner
import org.robolectric.annotation.Config
import org.robolectric.shadows.ShadowAudioTrack
import robotran.ui.sound.PlannedTone
import robotran.ui.sound.ToneWave
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit

@RunWith(RobolectricTestRunner::class)
@Config(shadows = [UnknownPlayer::class])
class AudioTrackSpeakerTest {
    private val heard = LinkedBlockingQueue<Pair<AudioFormat, ByteArray>>()
    private val listener = ShadowAudioTrack.OnAudioDataWrittenListener { _, bytes, format -> heard += format to bytes }
    private val speaker = audioTrackSpeaker()

    @After
    fun close() {
        speaker.close()
        ShadowAudioTrack.removeAudioDataListener(listener)
    }

    @Test
    fun `a tone reaches Android's audio as samples`() {
        ShadowAudioTrack.addAudioDataListener(listener)
        speaker.play(PlannedTone(start = 0.0, hertz = 1000.0, duration = 50.0))
        val (format, bytes) = checkNotNull(heard.poll(20, TimeUnit.SECONDS)) { "nothing is heard" }
        assertEquals(ToneWave.SAMPLE_RATE, format.sampleRate)
        assertEquals(AudioFormat.ENCODING_PCM_16BIT, format.encoding)
        assertTrue(bytes.any { it.toInt() != 0 })
    }

    @Test
    fun `a track can be opened, emptied and given back`() {
        val line = checkNotNull(openAudioTrack())
        line.write(ByteArray(100))
        line.discard()
        line.close()
    }
}

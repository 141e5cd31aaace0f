package robotran.android.sound

import android.media.AudioAttributes
import android.media.AudioFormat
import android.media.AudioTrack
import robotran.ui.sound.SampleFeeder
import robotran.ui.sound.SampleLine
import robotran.workshop.sound.LoudSpeaker
import robotran.workshop.sound.ToneWave

/** The device's audio output, at media volume. */
internal fun audioTrackSpeaker(): LoudSpeaker = SampleFeeder(::openAudioTrack)

/** A playing track; null if Android provides none for any reason: a tone is not worth a crash. */
private fun openAudioTrack(): SampleLine? = try {
    val track = newTrack()
    track.play()
    AudioTrackLine(track)
} catch (_: RuntimeException) {
    null
}

private fun newTrack(): AudioTrack {
    val min = AudioTrack.getMinBufferSize(
        ToneWave.SAMPLE_RATE,
        AudioFormat.CHANNEL_OUT_STEREO,
        AudioFormat.ENCODING_PCM_16BIT,
    )
    return AudioTrack
        .Builder()
        .setAudioAttributes(
            AudioAttributes
                .Builder()
                .setUsage(AudioAttributes.USAGE_GAME)
                .setContentType(AudioAttributes.CONTENT_TYPE_SONIFICATION)
                .build(),
        ).setAudioFormat(
            AudioFormat
                .Builder()
                .setSampleRate(ToneWave.SAMPLE_RATE)
                .setChannelMask(AudioFormat.CHANNEL_OUT_STEREO)
                .setEncoding(AudioFormat.ENCODING_PCM_16BIT)
                .build(),
        ).setTransferMode(AudioTrack.MODE_STREAM)
        .setBufferSizeInBytes(maxOf(min, SampleLine.BUFFER_BYTES))
        .build()
}

/** [track] is playing. */
private class AudioTrackLine(private val track: AudioTrack) : SampleLine {
    override fun write(samples: ByteArray) {
        track.write(samples, 0, samples.size)
    }

    /** A track can drop its buffer only while paused. */
    override fun discard() {
        track.pause()
        track.flush()
        track.play()
    }

    override fun close() = track.release()
}

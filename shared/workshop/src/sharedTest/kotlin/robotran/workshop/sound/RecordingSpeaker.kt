package robotran.workshop.sound

/** A speaker that records its calls; the test sets its clock. */
internal class RecordingSpeaker : LoudSpeaker {
    override var milliseconds = 0.0
    val tones = mutableListOf<PlannedTone>()
    val ends = mutableListOf<Double>()
    var silences = 0
    var closed = false

    override fun play(tone: PlannedTone) {
        tones += tone
    }

    override fun endAt(milliseconds: Double) {
        ends += milliseconds
    }

    override fun silence() {
        silences++
    }

    override fun close() {
        closed = true
    }
}

package robotran.simulation.nxt

import robotran.nxt.hardware.Clock
import robotran.simulation.noise.NoiseStreams
import robotran.simulation.noise.NxtRealism
import robotran.world.geometry.Direction
import kotlin.math.floor

/** The five eyes of an infrared seeker of HiTechnic: 120 and 60 degrees to the left, ahead, 60 and 120 to the right. */
internal class SeekerEyes(
    private val scene: NxtScene,
    private val place: SensorPlace,
    streams: NoiseStreams,
    name: String,
    private val realism: Double,
) {
    private val noise = streams.named("$name: noise")

    /** What they see; only light that is [sent], or all infrared light. */
    fun see(sent: Boolean): InfraredView {
        place.aim()
        val amounts = EYES.map { eye ->
            val cosine = place.cosine * eye.cosine - place.sine * eye.sine
            val sine = place.sine * eye.cosine + place.cosine * eye.sine
            val amount = scene.light.infrared(place.point, cosine, sine, place.body, sent)
            val error = if (realism == 0.0) 0.0 else realism * NxtRealism.SEEKER_NOISE * noise.normal()
            maxOf(0.0, amount + error)
        }
        return InfraredView(amounts)
    }

    private companion object {
        val EYES = listOf(120.0, 60.0, 0.0, -60.0, -120.0).map { Direction(it) }
    }
}

/** What the eyes of a seeker see, from the left to the right, in the units of light. */
internal class InfraredView(private val amounts: List<Double>) {
    /** 0 to 255 each. */
    val strengths: List<Int> get() = amounts.map { floor(HIGHEST * it / (it + HALF_AMOUNT)).toInt() }

    /** 1 on the left to 5 ahead and 9 on the right, in steps of 30 degrees; 0 if there is nothing. */
    val direction: Int
        get() {
            val strongest = amounts.indices.maxBy { amounts[it] }
            if (amounts[strongest] < LEAST) return 0
            val left = amounts.getOrElse(strongest - 1) { 0.0 }
            val right = amounts.getOrElse(strongest + 1) { 0.0 }
            val between = if (maxOf(left, right) * 2 < amounts[strongest]) {
                0
            } else if (right > left) {
                1
            } else {
                -1
            }
            return 2 * strongest + 1 + between
        }

    companion object {
        /** Nobody, in the dark. */
        val DARK = InfraredView(List(5) { 0.0 })
        private const val HIGHEST = 255
        private const val HALF_AMOUNT = 0.5

        /** A lamp of brightness 1 at 2.5 metres. */
        private const val LEAST = 0.0096
    }
}

/** The first infrared seeker of HiTechnic. */
internal class FirstSeeker(private val eyes: SeekerEyes, private val clock: Clock) :
    RegisterDevice("V1.0", "HITECHNC", "DirInfra") {
    private var seen = InfraredView.DARK

    override var hasMeasured = false
        private set

    override val reading: Int get() = seen.direction

    override fun tick() {
        if (hasMeasured && clock.milliseconds() % SEEKER_PERIOD != 0L) return
        hasMeasured = true
        seen = eyes.see(sent = false)
    }

    override fun measure() {
        put(DATA, seen.direction)
        seen.strengths.forEachIndexed { eye, strength -> put(DATA + 1 + eye, strength) }
    }
}

/** The second infrared seeker of HiTechnic: it tells light that is sent from all infrared light. */
internal class SecondSeeker(private val eyes: SeekerEyes, private val clock: Clock) :
    RegisterDevice("V2.0", "HITECHNC", "NewIRDir") {
    private var all = InfraredView.DARK
    private var sent = InfraredView.DARK

    override val address: Int get() = SECOND_ADDRESS

    override var hasMeasured = false
        private set

    override val reading: Int get() = sent.direction

    override fun tick() {
        if (hasMeasured && clock.milliseconds() % SEEKER_PERIOD != 0L) return
        hasMeasured = true
        all = eyes.see(sent = false)
        sent = eyes.see(sent = true)
    }

    override fun measure() {
        put(DATA, all.direction)
        all.strengths.forEachIndexed { eye, strength -> put(DATA + 1 + eye, strength) }
        put(AVERAGE, all.strengths.sum() / all.strengths.size)
        put(SENT, sent.direction)
        sent.strengths.forEachIndexed { eye, strength -> put(SENT + 1 + eye, strength) }
    }

    private companion object {
        // Source: HiTechnic's table.
        const val SECOND_ADDRESS = 0x10
        const val AVERAGE = 0x48
        const val SENT = 0x49
    }
}

private const val SEEKER_PERIOD = 10L

package robotran.world

/**
 * The light model of the NXT's light sensor, in the units of [Light]. It makes white paper 58 percent and ink 32 with the
 * lamp on, in a dim room; 30 and 17 without it by day, as pupils have measured.
 */
object NxtLight {
    /** The percentage in the dark. */
    const val DARK = 14.2

    /** How far it can rise above that, and the amount of light at which half of this is reached. */
    const val SPAN = 72.8
    const val HALF_AMOUNT = 1.72

    /** The part of the ambient light that gets under the sensor. */
    const val UNDER_ROBOT = 0.27

    /** The light of the sensor's lamp that perfectly white paper reflects, up to 1 cm away. */
    const val OWN_LAMP = 2.578

    /** The light of the lamp that gets into the sensor by itself. */
    const val STRAY = 0.25

    /** How much the sensor sees of what a surface reflects: the lamp is red. */
    const val RED = 0.85
    const val GREEN = 0.1
    const val BLUE = 0.05

    /** The percentage for an [amount] of light. */
    fun percent(amount: Double): Double = DARK + SPAN * amount / (amount + HALF_AMOUNT)
}

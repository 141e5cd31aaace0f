package robotran.simulation.explain

import robotran.language.Language

/** The sentences of [DeviationCause]s in one language; numbers are text, already rounded. */
interface InfluenceMessages {
    fun startPlace(centimetres: String): String

    /** @param left whether the robot faced too far to the left. */
    fun startHeading(degrees: String, left: Boolean): String

    /**
     * @param leftMotor true for the left motor, false for the right one.
     * @param weak true if weaker than nominal, false if stronger.
     */
    fun strength(leftMotor: Boolean, weak: Boolean, perCent: String, centimetres: String): String

    /** @param left whether the effect turned the robot to the left. */
    fun flutter(centimetres: String, degrees: String, left: Boolean): String

    fun slip(centimetres: String): String

    fun spin(centimetres: String): String

    fun battery(volts: String, centimetres: String): String

    /** @param dark whether everything looks darker to the sensor than it is. */
    fun lightBias(raw: String, dark: Boolean): String

    fun lightNoise(raw: String): String

    fun bounce(times: Int): String

    companion object {
        fun of(language: Language): InfluenceMessages = when (language) {
            Language.ENGLISH -> EnglishInfluenceMessages
            Language.SPANISH -> SpanishInfluenceMessages
            Language.GERMAN -> GermanInfluenceMessages
        }
    }
}

internal object EnglishInfluenceMessages : InfluenceMessages {
    override fun startPlace(centimetres: String) = "The robot was put down $centimetres cm beside its place."

    override fun startHeading(degrees: String, left: Boolean) =
        "It looked $degrees degrees too far to the ${side(left)} when it was put down."

    override fun strength(leftMotor: Boolean, weak: Boolean, perCent: String, centimetres: String) =
        "The ${side(leftMotor)} motor is $perCent % too ${if (weak) "weak" else "strong"}: its wheel rolled " +
            "$centimetres cm ${if (weak) "less" else "more"} than it should."

    override fun flutter(centimetres: String, degrees: String, left: Boolean) =
        "The motors' speeds flutter: one wheel rolled $centimetres cm more by that, which turned the robot $degrees " +
            "degrees to the ${side(left)}."

    override fun slip(centimetres: String) =
        "The wheels slipped a little on the floor and lost $centimetres cm together."

    override fun spin(centimetres: String) =
        "The wheels turned $centimetres cm without grip, because something held the robot."

    override fun battery(volts: String, centimetres: String) =
        "The batteries are down to $volts volts: each wheel rolled $centimetres cm less than with fresh ones."

    override fun lightBias(raw: String, dark: Boolean) = "The light sensor measures $raw raw units too " +
        "${if (dark) "much, so everything looks darker" else "little, so everything looks lighter"} to it than it is."

    override fun lightNoise(raw: String) = "The light sensor's readings flicker by about $raw raw units."

    override fun bounce(times: Int) =
        "The switches of the bumpers bounced ${if (times == 1) "once" else "$times times"} when they were hit or let " +
            "go."

    private fun side(left: Boolean) = if (left) "left" else "right"
}

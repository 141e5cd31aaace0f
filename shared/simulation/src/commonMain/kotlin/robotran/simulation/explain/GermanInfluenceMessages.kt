package robotran.simulation.explain

import robotran.language.withComma

internal object GermanInfluenceMessages : InfluenceMessages {
    override fun startPlace(centimetres: String) =
        "Der Roboter wurde ${withComma(centimetres)} cm neben seinen Platz gestellt."

    override fun startHeading(degrees: String, left: Boolean) =
        "Beim Hinstellen schaute er ${withComma(degrees)} Grad zu weit nach ${side(left)}."

    override fun strength(leftMotor: Boolean, weak: Boolean, perCent: String, centimetres: String) =
        "Der ${if (leftMotor) "linke" else "rechte"} Motor ist ${withComma(perCent)} % zu " +
            "${if (weak) "schwach" else "stark"}: " +
            "Sein Rad ist ${withComma(centimetres)} cm ${if (weak) "weniger" else "mehr"} gerollt, als es sollte."

    override fun flutter(centimetres: String, degrees: String, left: Boolean) =
        "Die Motoren laufen nicht ganz gleichmäßig: Ein Rad ist dadurch ${withComma(centimetres)} cm mehr gerollt, " +
            "und das hat den Roboter ${withComma(degrees)} Grad nach ${side(left)} gedreht."

    override fun slip(centimetres: String) =
        "Die Räder sind auf dem Boden ein wenig gerutscht und haben zusammen ${withComma(centimetres)} cm verloren."

    override fun spin(centimetres: String) =
        "Die Räder haben sich ${withComma(centimetres)} cm ohne Halt gedreht, weil etwas den Roboter aufgehalten hat."

    override fun battery(volts: String, centimetres: String) =
        "Die Batterien haben nur noch ${withComma(volts)} Volt: Jedes Rad ist ${withComma(centimetres)} cm weniger " +
            "gerollt als mit neuen."

    override fun lightBias(raw: String, dark: Boolean) =
        "Der Lichtsensor misst ${withComma(raw)} Rohwerte zu ${if (dark) "viel" else "wenig"}, " +
            "also sieht für ihn alles ${if (dark) "dunkler" else "heller"} aus, als es ist."

    override fun lightNoise(raw: String) = "Die Werte des Lichtsensors zittern um etwa ${withComma(raw)} Rohwerte."

    override fun bounce(times: Int) = "Die Schalter der Stoßfühler haben beim Anstoßen oder Loslassen " +
        "${if (times == 1) "einmal" else "$times-mal"} geprellt."

    private fun side(left: Boolean) = if (left) "links" else "rechts"
}

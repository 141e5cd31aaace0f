package robotran.simulation.messages

import robotran.language.withComma

/** The sentences about what makes a robot with an NXT stray and its sensors err. Numbers have one decimal. */
interface NxtDeviationMessages {
    fun motorPlay(centimetres: String): String

    /** @param far whether everything seems to be farther away than it is. */
    fun sonarBias(centimetres: String, far: Boolean): String

    fun sonarNoise(centimetres: String): String

    /** @param parts of 255. */
    fun colourNoise(parts: String): String
}

internal object EnglishNxtDeviationMessages : NxtDeviationMessages {
    override fun motorPlay(centimetres: String) =
        "There is play between motors and wheels: whenever a motor changed direction, its wheel followed late, " +
            "$centimetres cm together."

    override fun sonarBias(centimetres: String, far: Boolean) =
        "The ultrasonic sensor measures $centimetres cm too ${if (far) "much" else "little"}, so everything seems to " +
            "be ${if (far) "farther away" else "nearer"} than it is."

    override fun sonarNoise(centimetres: String) = "The ultrasonic sensor's readings flicker by about $centimetres cm."

    override fun colourNoise(parts: String) = "The colour sensor's readings flicker by about $parts of 255."
}

internal object GermanNxtDeviationMessages : NxtDeviationMessages {
    override fun motorPlay(centimetres: String) =
        "Zwischen Motoren und Rädern ist Spiel: Wenn ein Motor die Richtung gewechselt hat, ist sein Rad erst später " +
            "gefolgt, zusammen ${withComma(centimetres)} cm."

    override fun sonarBias(centimetres: String, far: Boolean) =
        "Der Ultraschallsensor misst ${withComma(centimetres)} cm zu ${if (far) "viel" else "wenig"}: Alles scheint " +
            "${if (far) "weiter weg" else "näher"} zu sein, als es ist."

    override fun sonarNoise(centimetres: String) =
        "Die Werte des Ultraschallsensors zittern um etwa ${withComma(centimetres)} cm."

    override fun colourNoise(parts: String) = "Die Werte des Farbsensors zittern um etwa ${withComma(parts)} von 255."
}

internal object SpanishNxtDeviationMessages : NxtDeviationMessages {
    override fun motorPlay(centimetres: String) =
        "Hay holgura entre los motores y las ruedas: cuando un motor cambió de sentido, su rueda lo siguió " +
            "más tarde, en total ${withComma(centimetres)} cm."

    override fun sonarBias(centimetres: String, far: Boolean) = "El sensor de ultrasonidos mide " +
        "${withComma(centimetres)} cm ${if (far) "de más" else "de menos"}: todo parece " +
        "estar más ${if (far) "lejos" else "cerca"} de lo que está."

    override fun sonarNoise(centimetres: String) =
        "Lo que mide el sensor de ultrasonidos tiembla en unos ${withComma(centimetres)} cm."

    override fun colourNoise(parts: String) =
        "Lo que mide el sensor de color tiembla en unas ${withComma(parts)} unidades de 255."
}

package robotran.simulation.explain

import robotran.language.withComma

internal object SpanishInfluenceMessages : InfluenceMessages {
    override fun startPlace(centimetres: String) = "El robot se colocó a ${withComma(centimetres)} cm de su sitio."

    override fun startHeading(degrees: String, left: Boolean) =
        "Al colocarlo, miraba ${withComma(degrees)} grados de más hacia la ${side(left)}."

    override fun strength(leftMotor: Boolean, weak: Boolean, perCent: String, centimetres: String) =
        "El motor ${if (leftMotor) "izquierdo" else "derecho"} es un ${withComma(perCent)} % " +
            "demasiado ${if (weak) "débil" else "fuerte"}: su rueda ha rodado ${withComma(centimetres)} cm " +
            "${if (weak) "menos" else "más"} de lo que debía."

    override fun flutter(centimetres: String, degrees: String, left: Boolean) =
        "La velocidad de los motores tiembla: por eso una rueda ha rodado ${withComma(centimetres)} cm más, y el " +
            "robot ha girado " +
            "${withComma(degrees)} grados hacia la ${side(left)}."

    override fun slip(centimetres: String) =
        "Las ruedas han resbalado un poco en el suelo y han perdido ${withComma(centimetres)} cm entre las dos."

    override fun spin(centimetres: String) =
        "Las ruedas han girado ${withComma(centimetres)} cm sin agarrarse, porque algo sujetaba al robot."

    override fun battery(volts: String, centimetres: String) =
        "Las pilas han bajado a ${withComma(volts)} voltios: cada rueda ha rodado ${withComma(centimetres)} cm menos " +
            "que con pilas nuevas."

    override fun lightBias(raw: String, dark: Boolean) =
        "El sensor de luz mide ${withComma(raw)} unidades de ${if (dark) "más" else "menos"}, " +
            "así que lo ve todo más ${if (dark) "oscuro" else "claro"} de lo que es."

    override fun lightNoise(raw: String) = "Lo que mide el sensor de luz tiembla en unas ${withComma(raw)} unidades."

    override fun bounce(times: Int) =
        "Los interruptores de los parachoques han rebotado ${if (times == 1) "una vez" else "$times veces"} al " +
            "chocar o al soltarse."

    private fun side(left: Boolean) = if (left) "izquierda" else "derecha"
}

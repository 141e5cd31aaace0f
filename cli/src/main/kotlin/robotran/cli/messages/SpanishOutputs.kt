package robotran.cli.messages

import robotran.language.listed

internal object SpanishOutputMessages : OutputMessages {
    override fun unwritable(name: String, why: String) = "No se ha podido escribir $name: $why"

    override fun diskFull(name: String) =
        "No se ha podido escribir $name: el disco está lleno. Lo que había no ha cambiado."

    override fun notAFileName(name: String) = "$name no es un nombre de archivo."

    override fun isSymbolicLink(name: String, target: String) =
        "$name es un enlace a $target. Para cambiar ese archivo, usa su propio nombre."

    override fun isInput(name: String) =
        "Esta orden lee $name, así que no escribe nada ahí. Elige otro nombre para el resultado."

    override fun writtenTwice(name: String) = "Dos resultados irían a $name. Elige otro nombre para uno de ellos."

    override fun notAPicture(name: String, endings: List<String>) =
        "No se puede escribir $name: una imagen puede ser ${listed(endings, "o")}."

    override fun unexpected(problem: String) =
        "Algo ha fallado en el propio Robotran. Di a sus desarrolladores qué has hecho, y esto: $problem"
}

package robotran.cli.messages

/** Messages about serving the built site. */
internal interface WebMessages {
    /** @param folder the folder that was searched. */
    fun siteNotBuilt(folder: String): String

    fun siteNotHere(): String

    fun portTaken(port: Int): String

    fun siteServed(address: String): String
}

internal object EnglishWebMessages : WebMessages {
    override fun siteNotBuilt(folder: String) = "There is no built site in $folder. ./gradlew :webApp:dist makes it."

    override fun siteNotHere() =
        "This Robotran has no web site with it. Serve the one of its source tree by ./robotran web, or name a folder " +
            "by --site."

    override fun portTaken(port: Int) =
        "Port $port cannot be used, perhaps because another program uses it. Choose another one by --port."

    override fun siteServed(address: String) = "Robotran is at $address for this machine alone, until you press Ctrl+C."
}

internal object SpanishWebMessages : WebMessages {
    override fun siteNotBuilt(folder: String) =
        "En $folder no hay ninguna página construida. La construye ./gradlew :webApp:dist."

    override fun siteNotHere() =
        "Este Robotran no trae la página web. Sirve la de su código fuente con ./robotran web o di una carpeta con " +
            "--site."

    override fun portTaken(port: Int) =
        "El puerto $port no se puede usar, quizá porque lo usa otro programa. Elige otro con --port."

    override fun siteServed(address: String) =
        "Robotran está en $address, solo para esta máquina, hasta que pulses Ctrl+C."
}

internal object GermanWebMessages : WebMessages {
    override fun siteNotBuilt(folder: String) = "In $folder liegt keine gebaute Seite. ./gradlew :webApp:dist baut sie."

    override fun siteNotHere() =
        "Bei diesem Robotran ist keine Webseite dabei. Nimm ./robotran web im Quelltext-Ordner oder nenne einen " +
            "Ordner mit --site."

    override fun portTaken(port: Int) =
        "Port $port lässt sich nicht benutzen, vielleicht weil ein anderes Programm ihn hat. Wähle einen anderen mit " +
            "--port."

    override fun siteServed(address: String) =
        "Robotran ist unter $address zu finden, nur auf diesem Rechner, bis du Strg+C drückst."
}

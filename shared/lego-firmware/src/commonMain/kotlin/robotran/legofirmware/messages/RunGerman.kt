package robotran.legofirmware.messages

import robotran.language.quoted

internal object RunGerman : RunMessages {
    override fun nestedCall() = "Ein Unterprogramm hat dieses Unterprogramm aufgerufen. Ein RCX merkt sich nur einen " +
        "Rückweg. Deshalb halten alle Tasks an, wenn das erste Unterprogramm endet."

    override fun invalidOpcode(byte: Int, address: Int) =
        "Einen Befehl mit der Nummer $byte gibt es nicht (Adresse $address). Dieser Task hält hier an."

    override fun newerCommand(command: String) =
        "Firmware 1.0 hat keinen Befehl ${quoted(command)}. Dieser Task hält hier an."

    override fun requestOnly(command: String) =
        "${quoted(command)} geht nur über Infrarotlicht. Hier bewirkt es nichts."

    override fun divisionByZero() = "Eine Division durch 0 ändert nichts: Die Variable behält ihren Wert."

    override fun datalogFull(entries: Int) =
        "Der Datenspeicher ist voll: $entries Einträge. Weitere Werte gehen verloren."

    override fun noDatalog() = "Es gibt noch keinen Datenspeicher. Dieser Wert geht verloren. Lege zuerst einen an."

    override fun noTask(number: Int) = "Es gibt keinen Task $number. Deshalb startet nichts."

    override fun noSub(number: Int) = "Es gibt kein Unterprogramm $number. Deshalb geschieht nichts."

    override fun noVariable(number: Int) = "Es gibt keine Variable $number. Ihr Wert ist 0."

    override fun noSource(source: Int) = "Ein RCX hat keine Quelle $source. Ihr Wert ist 0."

    override fun notWritable(source: Int) = "Die Quelle $source kann man nur lesen. Nichts ändert sich."

    override fun wrongPower(power: Int) = "Die Leistung $power wird übergangen. Erlaubt ist 0 bis 7."

    override fun noPort(number: Int) =
        "Einen Anschluss, Timer, Zähler oder ein Ereignis mit der Nummer $number gibt es nicht. Nichts geschieht."

    override fun tooManyLoops() =
        "Höchstens vier Zählschleifen passen ineinander. Der Zähler der vierten geht verloren."

    override fun noLoop() = "Hier gibt es keine Zählschleife, die zu Ende sein könnte."

    override fun jumpOut() = "Dieser Sprung führt aus dem Task oder Unterprogramm hinaus. Es endet damit."

    override fun task(number: Int) = "Task $number"

    override fun sub(number: Int) = "Unterprogramm $number"

    override fun localVariables() = "eigene Variablen"

    override fun motorsStayOn() =
        "Das Programm ist zu Ende, aber die Motoren bleiben an: Die Firmware von LEGO hält sie " +
            "nicht an. Schalte sie am Ende des Programms aus."

    override fun emptySlot(slot: Int) = "Auf Platz $slot ist kein Programm. Wähle mit der Taste Prgm einen anderen."
}

package robotran.cli.messages

import robotran.language.listed

internal object GermanTowerMessages : TowerMessages {
    override fun lejosHasNoSlots() =
        "leJOS hat keine Programmplätze, der Stein behält nur das zuletzt Gesendete. Nenne mehrere Programme in " +
            "einem Befehl: Die Taste Prgm geht sie durch."

    override fun twoFirmwares() =
        "Diese Programme brauchen zwei Firmwares: .nqc, .lasm und .rcx die von LEGO, die anderen leJOS. Ein " +
            "Stein hat nur eine davon, sende sie also mit zwei Befehlen."

    override fun tooFewSlots(first: Int, programs: Int, last: Int) =
        "Ab Platz $first gibt es keine $programs Plätze: Der letzte ist Platz $last. Nenne weniger Programme " +
            "oder einen anderen --slot."

    override fun noTower() =
        "Es ist kein Infrarotturm da. Stecke ihn ein oder nenne seinen Anschluss mit --port. Unter Windows und " +
            "macOS geht der USB-Turm nur auf der Seite von Robotran, in Chrome."

    override fun noTowerAt(ports: List<String>) =
        "Kein Turm an ${listed(ports, "oder")}. Stecke den Turm ein und prüfe, ob seine Batterie gut ist."

    override fun portGone(port: String) =
        "Den Anschluss $port gibt es nicht. Stecke den Turm ein oder nenne einen anderen Anschluss mit --port."

    override fun portBusy(port: String) = "Ein anderes Programm benutzt $port. Schließe es und versuche es noch einmal."

    override fun portNotAllowed(port: String) =
        "Du darfst $port nicht benutzen. Unter Linux muss dich jemand, der es darf, in die Gruppe aufnehmen, der " +
            "die Datei gehört, oft dialout."

    override fun portHeld(port: String) =
        "Ein Treiber des Systems hält $port fest, deshalb kann Robotran ihn nicht benutzen."

    override fun towerAt(port: String) = "Der Turm ist an $port."

    override fun blocksSent(sent: Int, all: Int, secondsLeft: Int) = "$sent von $all Blöcken, noch $secondsLeft s"

    override fun programSent(bytes: Int) = "Der Stein hat das Programm, $bytes Bytes. Drücke Run."

    override fun programInSlot(bytes: Int, slot: Int) =
        "Der Stein hat das Programm auf Platz $slot, $bytes Bytes. Drücke Run."

    override fun entriesRead(read: Int, all: Int, secondsLeft: Int) = "$read von $all Einträgen, noch $secondsLeft s"

    override fun noDatalog() = "Das Datenprotokoll hat keine Einträge. Ein Programm in NQC macht sie mit AddToDatalog."

    override fun datalogWritten(name: String, entries: Int) =
        "$name wurde geschrieben: $entries Einträge des Datenprotokolls."

    override fun clockSet(time: String) = "Die Uhr des Steins zeigt $time."

    override fun notATime(text: String) = "$text ist keine Uhrzeit. Schreibe Stunden und Minuten, zum Beispiel 13:37."

    override fun slotEmptied(slot: Int) = "Platz $slot des Steins ist leer."

    override fun firmwareSent(bytes: Int) =
        "Der Stein hat seine Firmware, $bytes Bytes. Jetzt kannst du Programme senden."

    override fun firmwareIs(name: String, firmware: String) = "$name ist $firmware."

    override fun firmwareUnknown(name: String) =
        "$name ist keine Firmware, die Robotran kennt. Sie wird trotzdem gesendet."

    override fun notAFirmware(name: String) =
        "$name ist keine Firmware. Nimm lejos.srec von leJOS oder eine Datei von LEGO, deren Name mit .lgo endet."

    override fun firmwareDamaged(name: String, line: Int) =
        "$name ist in Zeile $line beschädigt. Lade oder kopiere die Datei noch einmal."

    override fun firmwareCutOff(name: String) = "$name hört zu früh auf. Lade oder kopiere die Datei noch einmal."

    override fun firmwareOutOfRange(name: String, line: Int) =
        "$name ist nicht für einen RCX: Zeile $line gehört in Speicher, den ein RCX nicht hat."

    override fun firmwareTooLarge(name: String, bytes: Int, limit: Int) =
        "$name ist zu groß für einen RCX: Es sind $bytes Bytes, und $limit sind möglich."

    override fun firmwareForOthers(name: String) =
        "$name ist nicht für einen RCX: Der Satz fehlt, den ein RCX sucht, bevor er eine Firmware startet."

    override fun towerGone() = "Der Turm wurde ausgesteckt. Stecke ihn ein und versuche es noch einmal."

    override fun towerSilent() =
        "An diesem Anschluss antwortet nichts. Vielleicht ist da kein Turm. Wenn doch, prüfe, ob es sein Anschluss " +
            "ist und ob seine Batterie gut ist."

    override fun brickSilent() =
        "Der Stein antwortet nicht. Schalte ihn ein, halte sein Programm an und stelle ihn eine Handbreit vor " +
            "den Turm."

    override fun noLejos() =
        "Auf dem Stein ist kein leJOS. Sende zuerst die Firmware von leJOS, mit robotran firmware lejos.srec."

    override fun legoInsteadOfLejos(version: String) =
        "Dieser Stein hat LEGOs eigene Firmware $version, und das Programm braucht leJOS. Sende zuerst die " +
            "Firmware von leJOS, mit robotran firmware lejos.srec. Für LEGOs Firmware schreibe das Programm in " +
            "NQC."

    override fun noLegoFirmware() =
        "Dieser Stein hat leJOS oder keine Firmware, und dafür ist LEGOs eigene Firmware nötig. Sende sie " +
            "zuerst, mit robotran firmware firm0328.lgo. Zeigt die Anzeige eine Spannung, hat der Stein leJOS."

    override fun legoFirmwareTooOld(version: String) =
        "Dieser Stein hat LEGOs Firmware $version, das ist Firmware 1.0, und das Programm ist für 2.0. Sende " +
            "Firmware 2.0 (firm0328.lgo oder neuer), oder übersetze das Programm mit --target rcx."

    override fun remainsAsBefore() = "Der Stein hat dasselbe wie vorher."

    override fun remainsNoProgram() = "Der Stein hat jetzt kein Programm. Sende es noch einmal."

    override fun remainsEmptySlot(slot: Int) =
        "Platz $slot des Steins ist jetzt leer, die anderen Plätze sind wie vorher. Sende das Programm noch einmal."

    override fun remainsNoFirmware() = "Der Stein hat jetzt keine Firmware. Sende sie noch einmal: Nichts ist kaputt."

    override fun remainsUnknown() = "Niemand weiß, was der Stein jetzt hat. Sende es noch einmal."

    override fun remainsUnknownSlot(slot: Int) =
        "Niemand weiß, was Platz $slot jetzt hat. Sende das Programm noch einmal. Die anderen Plätze sind wie vorher."

    override fun badConnection() =
        "Turm und Stein verstehen sich schlecht. Stelle sie näher zusammen, nicht ins helle Licht, mit guten " +
            "Batterien und ohne einen zweiten Stein in der Nähe."

    override fun batteryLow(volts: String) = "Die Batterien haben nur noch $volts V. Lege zuerst neue ein."

    override fun programTooLarge(bytes: Int, limit: Int) =
        "Das Programm ist zu groß für den Stein: Es hat $bytes Bytes, und $limit sind möglich."

    override fun brickFull(bytes: Int) =
        "Der Stein hat keinen Platz für weitere $bytes Bytes. Leere Plätze, die du nicht mehr brauchst, mit " +
            "robotran brick empty 2 3."

    override fun firmwareRefused() =
        "Der Stein startet diese Firmware nicht. Nimm eine andere Datei oder sende sie noch einmal."

    override fun brickHasLejosOrNothing(rom: String) =
        "Auf dem Stein ist leJOS oder keine Firmware: Beide antworten gleich. Zeigt die Anzeige eine Spannung, " +
            "ist es leJOS. Das ROM hat Version $rom."

    override fun brickHasLego(firmware: String, rom: String) =
        "Auf dem Stein ist LEGOs Firmware $firmware. Das ROM hat Version $rom."

    override fun batteryIs(volts: String) = "Die Batterien haben $volts V."

    override fun brickIsUnknown() = "Ein Stein antwortet, sagt aber nicht, was er ist."
}

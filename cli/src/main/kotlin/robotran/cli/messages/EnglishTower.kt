package robotran.cli.messages

import robotran.language.listed

internal object EnglishTowerMessages : TowerMessages {
    override fun lejosHasNoSlots() =
        "leJOS has no slots, so a brick keeps only what you sent last. Name several programs in one command: the " +
            "Prgm button goes through them."

    override fun twoFirmwares() =
        "These programs need two firmwares: .nqc, .lasm and .rcx need LEGO's own, the others leJOS. A brick has " +
            "only one of them, so send them in two commands."

    override fun tooFewSlots(first: Int, programs: Int, last: Int) =
        "There are no $programs slots from slot $first on: the last one is slot $last. Name fewer programs or " +
            "another --slot."

    override fun noTower() =
        "There is no tower. Plug it in, or name its port with --port. On Windows and macOS the USB tower works " +
            "only in Robotran's page, in Chrome."

    override fun noTowerAt(ports: List<String>) =
        "There is no tower at ${listed(ports, "or")}. Plug the tower in and look whether its battery is good."

    override fun portGone(port: String) = "There is no port $port. Plug the tower in, or name another port with --port."

    override fun portBusy(port: String) = "Another program uses $port. Close it and try again."

    override fun portNotAllowed(port: String) =
        "You may not use $port. On Linux, ask somebody who may to add you to the group that the file belongs to, " +
            "often dialout."

    override fun portHeld(port: String) = "A driver of the system holds $port, so Robotran cannot use it."

    override fun towerAt(port: String) = "The tower is at $port."

    override fun blocksSent(sent: Int, all: Int, secondsLeft: Int) = "$sent of $all blocks, $secondsLeft s left"

    override fun programSent(bytes: Int) = "The brick has the program, $bytes bytes. Press Run."

    override fun programInSlot(bytes: Int, slot: Int) =
        "The brick has the program in slot $slot, $bytes bytes. Press Run."

    override fun entriesRead(read: Int, all: Int, secondsLeft: Int) = "$read of $all entries, $secondsLeft s left"

    override fun noDatalog() = "The datalog has no entries. A program in NQC makes them with AddToDatalog."

    override fun datalogWritten(name: String, entries: Int) = "Wrote $name: $entries entries of the datalog."

    override fun clockSet(time: String) = "The clock of the brick shows $time."

    override fun notATime(text: String) = "$text is not a time. Write hours and minutes, such as 13:37."

    override fun slotEmptied(slot: Int) = "Slot $slot of the brick is empty."

    override fun firmwareSent(bytes: Int) = "The brick has its firmware, $bytes bytes. Now you can send programs."

    override fun firmwareIs(name: String, firmware: String) = "$name is $firmware."

    override fun firmwareUnknown(name: String) =
        "$name is none of the firmwares that Robotran knows. It is sent all the same."

    override fun notAFirmware(name: String) =
        "$name is not a firmware. Take lejos.srec of leJOS, or a file whose name ends with .lgo of LEGO."

    override fun firmwareDamaged(name: String, line: Int) =
        "$name is damaged in line $line. Download or copy the file again."

    override fun firmwareCutOff(name: String) = "$name ends too early. Download or copy the file again."

    override fun firmwareOutOfRange(name: String, line: Int) =
        "$name is not for an RCX: line $line is for memory that an RCX does not have."

    override fun firmwareTooLarge(name: String, bytes: Int, limit: Int) =
        "$name is too large for an RCX: it has $bytes bytes, and $limit are possible."

    override fun firmwareForOthers(name: String) =
        "$name is not for an RCX: it lacks the words that an RCX looks for before it starts a firmware."

    override fun towerGone() = "The tower was unplugged. Plug it in and try again."

    override fun towerSilent() =
        "Nothing answers at this port. Perhaps there is no tower. If there is one, look whether this is its port, " +
            "and whether its battery is good."

    override fun brickSilent() =
        "The brick does not answer. Switch it on, stop its program, and put it in front of the tower, a hand's " +
            "width away."

    override fun noLejos() = "The brick has no leJOS. Send leJOS's firmware first, with robotran firmware lejos.srec."

    override fun legoInsteadOfLejos(version: String) =
        "This brick has LEGO's own firmware $version, and the program needs leJOS. Send leJOS's firmware first, " +
            "with robotran firmware lejos.srec. For LEGO's firmware, write the program in NQC."

    override fun noLegoFirmware() =
        "This brick has leJOS, or no firmware, and this needs LEGO's own firmware. Send it first, with " +
            "robotran firmware firm0328.lgo. If the display shows a voltage, the brick has leJOS."

    override fun legoFirmwareTooOld(version: String) =
        "This brick has LEGO's firmware $version, which is firmware 1.0, and the program is for 2.0. Send " +
            "firmware 2.0 (firm0328.lgo or later), or build the program with --target rcx."

    override fun remainsAsBefore() = "The brick has the same as before."

    override fun remainsNoProgram() = "The brick has no program now. Send it again."

    override fun remainsEmptySlot(slot: Int) =
        "Slot $slot of the brick is empty now, and the other slots are as before. Send the program again."

    override fun remainsNoFirmware() = "The brick has no firmware now. Send it again: nothing is broken."

    override fun remainsUnknown() = "Nobody knows what the brick has now. Send it again."

    override fun remainsUnknownSlot(slot: Int) =
        "Nobody knows what slot $slot has now. Send the program again. The other slots are as before."

    override fun badConnection() =
        "Tower and brick understand each other badly. Put them closer together, out of bright light, with good " +
            "batteries and no second brick near."

    override fun batteryLow(volts: String) = "The batteries have only $volts V. Put new ones in first."

    override fun programTooLarge(bytes: Int, limit: Int) =
        "The program is too large for the brick: it has $bytes bytes, and $limit are possible."

    override fun brickFull(bytes: Int) =
        "The brick has no room for $bytes bytes more. Empty slots that you do not need any more, with robotran " +
            "brick empty 2 3."

    override fun firmwareRefused() = "The brick does not start this firmware. Take another file, or send it again."

    override fun brickHasLejosOrNothing(rom: String) =
        "The brick has leJOS, or no firmware: both answer alike. If its display shows a voltage, it is leJOS. " +
            "The ROM is version $rom."

    override fun brickHasLego(firmware: String, rom: String) =
        "The brick has LEGO's firmware $firmware. The ROM is version $rom."

    override fun batteryIs(volts: String) = "The batteries have $volts V."

    override fun brickIsUnknown() = "A brick answers, but does not tell what it is."
}

package robotran.programs.messages

object GermanProgramMessages : ProgramMessages {
    override fun inTranslation(message: String) = "$message (im Java, das daraus wird)"

    override fun forOtherBrick(program: String, robot: String) =
        "Dieses Programm ist für einen $program, aber der Roboter hat einen $robot. Gib es einem Roboter mit einem " +
            "$program."

    override fun noImageFor(brick: String) =
        "Dieses Programm ist für einen $brick. Nur Programme für einen RCX lassen sich für einen echten Stein bauen."

    override fun noImageForFirmware() =
        "Dieses Programm ist für LEGOs eigene Firmware, also passt es in kein Abbild für leJOS. Baue es allein, in " +
            "eine Datei wie programm.rcx."

    override fun compilesTooLong() =
        "Dieses Programm beschäftigt den Java-Compiler zu lange. Mach es einfacher: Steck weniger Blöcke ineinander, " +
            "oder mach aus einer langen Methode mehrere kurze."
}

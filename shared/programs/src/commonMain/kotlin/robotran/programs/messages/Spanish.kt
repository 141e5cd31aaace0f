package robotran.programs.messages

object SpanishProgramMessages : ProgramMessages {
    override fun inTranslation(message: String) = "$message (en el Java en que se convierte)"

    override fun forOtherBrick(program: String, robot: String) =
        "Este programa es para un $program, pero el robot tiene un $robot. Dáselo a un robot con un $program."

    override fun noImageFor(brick: String) =
        "Este programa es para un $brick. Solo los programas para un RCX se pueden preparar para un ladrillo real."

    override fun noImageForFirmware() =
        "Este programa es para el firmware propio de LEGO, así que no cabe en una imagen para leJOS. Prepáralo solo, " +
            "en un archivo como programa.rcx."

    override fun compilesTooLong() =
        "Este programa ocupa demasiado tiempo al compilador de Java. Hazlo más sencillo: pon menos bloques unos " +
            "dentro de otros o haz varios métodos cortos de uno largo."
}

package robotran.programs.messages

object EnglishProgramMessages : ProgramMessages {
    override fun inTranslation(message: String) = "$message (in the Java that it becomes)"

    override fun forOtherBrick(program: String, robot: String) =
        "This program is for an $program, but the robot has an $robot. Give it to a robot with an $program."

    override fun noImageFor(brick: String) =
        "This program is for an $brick. Only programs for an RCX can be built for a real brick."

    override fun noImageForFirmware() =
        "This program is for LEGO's own firmware, so it cannot be in an image for leJOS. Build it alone, to a file " +
            "such as program.rcx."

    override fun compilesTooLong() =
        "This program keeps the compiler for Java busy for too long. Make it simpler: put fewer blocks into each " +
            "other, or make several short methods of a long one."
}

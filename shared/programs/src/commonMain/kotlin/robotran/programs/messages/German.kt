package robotran.programs.messages

object GermanProgramMessages : ProgramMessages {
    override fun inTranslation(message: String) = "$message (im Java, das daraus wird)"
}

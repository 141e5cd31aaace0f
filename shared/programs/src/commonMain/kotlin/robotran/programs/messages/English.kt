package robotran.programs.messages

object EnglishProgramMessages : ProgramMessages {
    override fun inTranslation(message: String) = "$message (in the Java that it becomes)"
}

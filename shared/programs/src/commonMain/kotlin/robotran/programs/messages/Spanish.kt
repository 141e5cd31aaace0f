package robotran.programs.messages

object SpanishProgramMessages : ProgramMessages {
    override fun inTranslation(message: String) = "$message (en el Java en que se convierte)"
}

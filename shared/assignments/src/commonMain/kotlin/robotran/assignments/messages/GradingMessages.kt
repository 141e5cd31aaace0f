package robotran.assignments.messages

import robotran.language.Language
import robotran.language.choose

/** Why a hand-in could not be graded, in whole sentences. */
interface GradingMessages {
    /** @param why what the platform says. */
    fun couldNotBeGraded(why: String): String

    companion object {
        fun of(language: Language): GradingMessages =
            language.choose(EnglishGradingMessages, SpanishGradingMessages, GermanGradingMessages)
    }
}

private object EnglishGradingMessages : GradingMessages {
    override fun couldNotBeGraded(why: String) = "It could not be graded: something went wrong in Robotran ($why)."
}

private object SpanishGradingMessages : GradingMessages {
    override fun couldNotBeGraded(why: String) = "No se ha podido evaluar: algo ha fallado en Robotran ($why)."
}

private object GermanGradingMessages : GradingMessages {
    override fun couldNotBeGraded(why: String) =
        "Es konnte nicht bewertet werden: In Robotran ging etwas schief ($why)."
}

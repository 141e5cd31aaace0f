package robotran.assignments.course

import robotran.language.Language
import robotran.language.choose

/** What the courses that come with Robotran say about themselves. */
internal interface CourseMessages {
    /** The title of the course of the gallery's worlds. */
    fun worlds(): String

    /** A sentence about it. */
    fun aboutWorlds(): String

    companion object {
        fun of(language: Language): CourseMessages =
            language.choose(EnglishCourseMessages, SpanishCourseMessages, GermanCourseMessages)
    }
}

private object EnglishCourseMessages : CourseMessages {
    override fun worlds() = "Worlds with a task"

    override fun aboutWorlds() = "One task in each world, the easy ones first. You may do them in any order."
}

private object SpanishCourseMessages : CourseMessages {
    override fun worlds() = "Mundos con una tarea"

    override fun aboutWorlds() = "Una tarea en cada mundo, primero las fáciles. Puedes hacerlas en cualquier orden."
}

private object GermanCourseMessages : CourseMessages {
    override fun worlds() = "Welten mit einer Aufgabe"

    override fun aboutWorlds() =
        "In jeder Welt eine Aufgabe, die leichten zuerst. Du kannst sie in beliebiger Reihenfolge lösen."
}

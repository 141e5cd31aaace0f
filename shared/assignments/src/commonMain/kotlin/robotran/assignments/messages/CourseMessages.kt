package robotran.assignments.messages

import robotran.language.Language
import robotran.language.choose

/** The error messages for courses, and what our own courses are called. */
interface CourseMessages {
    /** A whole sentence. */
    fun notACourse(format: String): String

    /** A whole sentence. */
    fun newerCourse(version: Int, known: Int): String

    /** A whole sentence: the folder has no list of its assignments. */
    fun noCourseFile(name: String): String

    /** A whole sentence. */
    fun missingFile(name: String): String

    /** A whole sentence: a file of the course holds any other project. */
    fun mustBeAssignment(): String

    /** Follows the path of a value, without a full stop, as does the next. */
    fun mustHaveAssignment(): String

    fun idTwice(id: String): String

    /** The title of the course of all worlds of the gallery. */
    fun worldsTitle(): String

    fun aboutWorlds(): String

    companion object {
        fun of(language: Language): CourseMessages =
            language.choose(EnglishCourseMessages, SpanishCourseMessages, GermanCourseMessages)
    }
}

private object EnglishCourseMessages : CourseMessages {
    override fun notACourse(format: String) =
        "This is not a course of Robotran: the file of a course says \"format\": \"$format\"."

    override fun newerCourse(version: Int, known: Int) =
        "This course was made by a newer Robotran (it has version $version, this Robotran reads up to $known)."

    override fun noCourseFile(name: String) = "There is no file $name, which lists the assignments of a course."

    override fun missingFile(name: String) = "The course names the file $name, which is not there."

    override fun mustBeAssignment() = "This project of the course is not an assignment."

    override fun mustHaveAssignment() = "must have \"assignment\""

    override fun idTwice(id: String) = "has two assignments with the id \"$id\""

    override fun worldsTitle() = "The worlds of Robotran"

    override fun aboutWorlds() = "Each world has a task, from easy to hard."
}

private object SpanishCourseMessages : CourseMessages {
    override fun notACourse(format: String) =
        "Esto no es un curso de Robotran: el archivo de un curso dice \"format\": \"$format\"."

    override fun newerCourse(version: Int, known: Int) =
        "Este curso se hizo con un Robotran más nuevo (tiene la versión $version, y este Robotran lee hasta la $known)."

    override fun noCourseFile(name: String) = "No hay ningún archivo $name, que enumera las tareas de un curso."

    override fun missingFile(name: String) = "El curso nombra el archivo $name, que no está."

    override fun mustBeAssignment() = "Este proyecto del curso no es una tarea."

    override fun mustHaveAssignment() = "tiene que tener \"assignment\""

    override fun idTwice(id: String) = "tiene dos tareas con el id \"$id\""

    override fun worldsTitle() = "Los mundos de Robotran"

    override fun aboutWorlds() = "Cada mundo tiene una tarea, de fácil a difícil."
}

private object GermanCourseMessages : CourseMessages {
    override fun notACourse(format: String) =
        "Das ist kein Kurs von Robotran: In der Datei eines Kurses steht \"format\": \"$format\"."

    override fun newerCourse(version: Int, known: Int) =
        "Dieser Kurs wurde mit einem neueren Robotran gemacht (er hat Version $version, dieses Robotran liest bis " +
            "$known)."

    override fun noCourseFile(name: String) = "Es gibt keine Datei $name, in der die Aufgaben eines Kurses stehen."

    override fun missingFile(name: String) = "Der Kurs nennt die Datei $name, die nicht da ist."

    override fun mustBeAssignment() = "Dieses Projekt des Kurses ist keine Aufgabe."

    override fun mustHaveAssignment() = "muss \"assignment\" haben"

    override fun idTwice(id: String) = "hat zwei Aufgaben mit der id \"$id\""

    override fun worldsTitle() = "Die Welten von Robotran"

    override fun aboutWorlds() = "Zu jeder Welt gibt es eine Aufgabe, von leicht bis schwer."
}

package robotran.projects.messages

import robotran.language.listed

internal object SpanishProjectMessages : ProjectMessages {
    override fun notAProject(format: String) =
        "Esto no es un proyecto de Robotran: un archivo de proyecto dice \"format\": \"$format\"."

    override fun newerProject(version: Int, known: Int) =
        "Este proyecto se hizo con un Robotran más nuevo (tiene la versión $version, y este Robotran lee hasta la " +
            "$known)."

    override fun robotTwice(name: String) = "trata de \"$name\", y uno anterior ya lo hace"

    override fun mustNameRobotOfWorld() = "tiene que ser el nombre de un robot del mundo"

    override fun mustNotHave(field: String) = "no puede tener \"$field\""

    override fun mustBeOneLine() = "tiene que ser una sola línea"

    override fun beforeInputAbove() = "no puede ser anterior a la entrada de encima"

    override fun mustBeBytes() = "deben ser bytes en Base64"

    override fun mustFitIntoFlash() = "deben ser archivos que quepan en un NXT"

    override fun mustBeBase64() = "debe ser una imagen en Base64"

    override fun tooManySeeds(limit: Int) = "no deben ser más de $limit semillas"

    override fun mustNotBeLongerThan(characters: Int) = "no debe tener más de $characters caracteres"

    override fun noLamp() = "no puede ser, porque el mundo no tiene ninguna lámpara"

    override fun noBlock() = "no puede ser, porque el mundo no tiene ningún bloque"

    override fun notACourse(format: String) =
        "Esto no es un curso de Robotran: un archivo de curso dice \"format\": \"$format\"."

    override fun newerCourse(version: Int, known: Int) =
        "Este curso se hizo con un Robotran más nuevo (tiene la versión $version, y este Robotran lee hasta la " +
            "$known)."

    override fun mustBeAssignment() = "tiene que ser una tarea"

    override fun assignmentTwice(id: String) = "tiene el id \"$id\", y una tarea anterior también"

    override fun mustBeFileName() = "tiene que ser el nombre de un archivo junto al curso, sin carpeta"

    override fun fileNotBeside(name: String) = "necesita el archivo \"$name\"; ábrelo junto con el curso"

    override fun notALink() = "Esto no es un enlace a un mundo, a un proyecto o a un curso de Robotran."

    override fun handInLink() =
        "Esto es lo que alguien ha entregado. Se abre en \"Ver las entregas\", junto con la tarea."

    override fun linkTooLong(limit: String) = "El enlace es demasiado largo: tiene más de $limit letras y signos."

    override fun newerLink() = "Este enlace se hizo con un Robotran más nuevo."

    override fun linkBroken() = "El enlace está roto o no está entero; quizá se perdió una parte al copiarlo."

    override fun linkUnusable(why: String) = "Lo que hay en el enlace no se puede usar. $why"

    override fun worldTooLong(characters: String, limit: String) = tooLong("mundo", characters, limit)

    override fun projectTooLong(characters: String, limit: String) = tooLong("proyecto", characters, limit)

    override fun projectPicturesTooLong(characters: String, limit: String) =
        picturesTooLong("proyecto", characters, limit)

    override fun courseTooLong(characters: String, limit: String) = tooLong("curso", characters, limit)

    override fun coursePicturesTooLong(characters: String, limit: String) = picturesTooLong("curso", characters, limit)

    override fun unknownRobot(name: String, robots: List<String>): String {
        val known = if (robots.size == 1) {
            "Solo hay uno, que se llama ${robots.single()}."
        } else {
            "Están ${listed(robots, "y")}."
        }
        return "Ningún robot de este mundo se llama $name. $known"
    }

    override fun robotUnfinished(robot: String, title: String, why: String) =
        "El robot $robot no está terminado: «$title» no puede conducir. $why"

    override fun tooManyPrograms(robot: String, count: Int, limit: Int) =
        "El robot $robot ha recibido $count programas, pero en un ladrillo caben $limit."

    private fun picturesTooLong(what: String, characters: String, limit: String) =
        "Este $what es demasiado largo para un enlace por sus imágenes: ocuparía $characters letras y signos, y como " +
            "mucho pueden ser $limit. Comparte mejor su archivo, o quita imágenes."

    private fun tooLong(what: String, characters: String, limit: String) =
        "Este $what es demasiado largo para un enlace: ocuparía $characters letras y signos, y como mucho pueden ser " +
            "$limit. Comparte mejor su archivo."
}

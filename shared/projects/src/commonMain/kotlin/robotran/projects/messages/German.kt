package robotran.projects.messages

import robotran.language.listed

internal object GermanProjectMessages : ProjectMessages {
    override fun notAProject(format: String) =
        "Das ist kein Projekt von Robotran: In einer Projektdatei steht \"format\": \"$format\"."

    override fun newerProject(version: Int, known: Int) =
        "Dieses Projekt wurde mit einem neueren Robotran gemacht (es hat Version $version, dieses Robotran liest bis " +
            "$known)."

    override fun robotTwice(name: String) = "handelt von \"$name\", und das tut schon einer davor"

    override fun mustNameRobotOfWorld() = "muss der Name eines Roboters der Welt sein"

    override fun mustNotHave(field: String) = "darf \"$field\" nicht haben"

    override fun mustBeOneLine() = "muss eine einzige Zeile sein"

    override fun beforeInputAbove() = "darf nicht vor der Eingabe darüber sein"

    override fun mustBeBytes() = "muss aus Bytes in Base64 bestehen"

    override fun mustFitIntoFlash() = "muss aus Dateien bestehen, die in einen NXT passen"

    override fun mustBeBase64() = "muss ein Bild in Base64 sein"

    override fun tooManySeeds(limit: Int) = "dürfen nicht mehr als $limit Seeds sein"

    override fun mustNotBeLongerThan(characters: Int) = "darf nicht mehr als $characters Zeichen haben"

    override fun noLamp() = "kann nicht sein, denn die Welt hat keine Lampe"

    override fun noBlock() = "kann nicht sein, denn die Welt hat keinen Klotz"

    override fun notACourse(format: String) =
        "Das ist kein Kurs von Robotran: In einer Kursdatei steht \"format\": \"$format\"."

    override fun newerCourse(version: Int, known: Int) =
        "Dieser Kurs wurde mit einem neueren Robotran gemacht (er hat Version $version, dieses Robotran liest bis " +
            "$known)."

    override fun mustBeAssignment() = "muss eine Aufgabe sein"

    override fun assignmentTwice(id: String) = "hat die ID \"$id\", und die hat schon eine Aufgabe davor"

    override fun mustBeFileName() = "muss der Name einer Datei neben dem Kurs sein, ohne Ordner"

    override fun fileNotBeside(name: String) = "braucht die Datei \"$name\"; öffne sie zusammen mit dem Kurs"

    override fun notALink() = "Das ist kein Link zu einer Welt, einem Projekt oder einem Kurs von Robotran."

    override fun handInLink() =
        "Das ist eine Abgabe. Lehrer öffnen sie unter \"Abgaben ansehen\", zusammen mit der Aufgabe."

    override fun linkTooLong(limit: String) = "Der Link ist zu lang: Er hat mehr als $limit Zeichen."

    override fun newerLink() = "Dieser Link wurde mit einem neueren Robotran gemacht."

    override fun linkBroken() = "Der Link ist kaputt oder nicht ganz; vielleicht ging beim Kopieren ein Stück verloren."

    override fun linkUnusable(why: String) = "Was in dem Link steckt, kann nicht benutzt werden. $why"

    override fun worldTooLong(characters: String, limit: String) = tooLong("Diese Welt", "Sie", characters, limit)

    override fun projectTooLong(characters: String, limit: String) = tooLong("Dieses Projekt", "Es", characters, limit)

    override fun projectPicturesTooLong(characters: String, limit: String) =
        picturesTooLong("Dieses Projekt", "Es", characters, limit)

    override fun courseTooLong(characters: String, limit: String) = tooLong("Dieser Kurs", "Er", characters, limit)

    override fun coursePicturesTooLong(characters: String, limit: String) =
        picturesTooLong("Dieser Kurs", "Er", characters, limit)

    override fun unknownRobot(name: String, robots: List<String>): String {
        val known = if (robots.size == 1) {
            "Es gibt nur einen, der heißt ${robots.single()}."
        } else {
            "Es gibt ${listed(robots, "und")}."
        }
        return "Kein Roboter in dieser Welt heißt $name. $known"
    }

    override fun robotUnfinished(robot: String, title: String, why: String) =
        "Der Roboter $robot ist nicht fertig: „$title“ kann nicht fahren. $why"

    override fun tooManyPrograms(robot: String, count: Int, limit: Int) =
        "Der Roboter $robot hat $count Programme bekommen, aber in einen Stein passen nur $limit."

    private fun picturesTooLong(what: String, pronoun: String, characters: String, limit: String) =
        "$what ist wegen der Bilder zu lang für einen Link: $pronoun würde $characters Zeichen brauchen, und " +
            "höchstens $limit gehen. Teil stattdessen die Datei, oder nimm Bilder heraus."

    private fun tooLong(what: String, pronoun: String, characters: String, limit: String) =
        "$what ist zu lang für einen Link: $pronoun würde $characters Zeichen brauchen, und höchstens $limit gehen. " +
            "Teil stattdessen die Datei."
}

package robotran.projects.messages

import robotran.language.listed

internal object EnglishProjectMessages : ProjectMessages {
    override fun notAProject(format: String) =
        "This is not a Robotran project: a project file says \"format\": \"$format\"."

    override fun newerProject(version: Int, known: Int) =
        "This project was made by a newer Robotran (it has version $version, this Robotran reads up to $known)."

    override fun robotTwice(name: String) = "is about \"$name\", and one before is so already"

    override fun mustNameRobotOfWorld() = "must be the name of a robot of the world"

    override fun mustNotHave(field: String) = "must not have \"$field\""

    override fun mustBeOneLine() = "must be one line"

    override fun beforeInputAbove() = "must not be before the input above it"

    override fun mustBeBytes() = "must be bytes in Base64"

    override fun mustFitIntoFlash() = "must be files that fit into an NXT"

    override fun mustBeBase64() = "must be a picture in Base64"

    override fun tooManySeeds(limit: Int) = "must not be more than $limit seeds"

    override fun mustNotBeLongerThan(characters: Int) = "must not have more than $characters characters"

    override fun noLamp() = "cannot be, since the world has no lamp"

    override fun noBlock() = "cannot be, since the world has no block"

    override fun notACourse(format: String) =
        "This is not a Robotran course: a course file says \"format\": \"$format\"."

    override fun newerCourse(version: Int, known: Int) =
        "This course was made with a newer Robotran (it has version $version, this Robotran reads up to $known)."

    override fun mustBeAssignment() = "must be an assignment"

    override fun assignmentTwice(id: String) = "has the id \"$id\", and so has an assignment before it"

    override fun mustBeFileName() = "must be the name of a file beside the course, without a folder"

    override fun fileNotBeside(name: String) = "needs the file \"$name\"; open it together with the course"

    override fun notALink() = "This is not a link to a world, a project or a course of Robotran."

    override fun handInLink() =
        "This is what somebody has handed in. A teacher opens it under \"Look at hand-ins\", together with the " +
            "assignment."

    override fun linkTooLong(limit: String) = "The link is too long: more than $limit characters."

    override fun newerLink() = "This link was made by a newer Robotran."

    override fun linkBroken() = "The link is broken or not whole; perhaps a part of it was lost when it was copied."

    override fun linkUnusable(why: String) = "What the link holds cannot be used. $why"

    override fun worldTooLong(characters: String, limit: String) = tooLong("world", characters, limit)

    override fun projectTooLong(characters: String, limit: String) = tooLong("project", characters, limit)

    override fun projectPicturesTooLong(characters: String, limit: String) =
        picturesTooLong("project", characters, limit)

    override fun courseTooLong(characters: String, limit: String) = tooLong("course", characters, limit)

    override fun coursePicturesTooLong(characters: String, limit: String) = picturesTooLong("course", characters, limit)

    override fun unknownRobot(name: String, robots: List<String>): String {
        val known = if (robots.size == 1) {
            "There is only one, called ${robots.single()}."
        } else {
            "There are ${listed(robots, "and")}."
        }
        return "No robot in this world is called $name. $known"
    }

    override fun robotUnfinished(robot: String, title: String, why: String) =
        "The robot $robot is not finished: \"$title\" cannot drive. $why"

    override fun tooManyPrograms(robot: String, count: Int, limit: Int) =
        "The robot $robot has been given $count programs, but a brick has room for $limit."

    private fun picturesTooLong(what: String, characters: String, limit: String) =
        "This $what is too long for a link because of its pictures: it would take $characters characters, and $limit " +
            "are the most. Share its file instead, or take pictures out."

    private fun tooLong(what: String, characters: String, limit: String) =
        "This $what is too long for a link: it would take $characters characters, and $limit are the most. Share its " +
            "file instead."
}

package robotran.workshop.assignment

import robotran.projects.Course
import robotran.projects.Project
import robotran.projects.writeCourse
import robotran.workshop.platform.OpenRequest
import robotran.workshop.platform.OpenedFile

/** A course as its author has it: three times [AnyAssignment] under other names. */
internal object AnyCourse {
    val teachers = Course(
        "Circles",
        "Three circles for the first week.\n\nDo them in this order.",
        listOf("Into the circle", "Out of the circle", "Around the circle").mapIndexed {
            index,
            title,
            ->
            task(index + 1, title)
        },
        "circles-1",
    )

    fun task(number: Int, title: String): Project = AnyAssignment.teachers.copy(
        world = AnyAssignment.world.copy(title = title),
        assignment = AnyAssignment.assignment.copy(id = "circle-$number"),
    )

    fun file(course: Course, name: String = "circles.course.json") =
        OpenedFile(name, writeCourse(course).encodeToByteArray(), "/home/$name")

    fun request(course: Course) = OpenRequest.OfFiles(listOf(file(course)))
}

package robotran.ui.school.tags

/** The tags of courses, by which tests and the page find what is on the screen. */
object CourseTags {
    const val COURSE = "course"
    const val COURSES = "courses"
    const val COURSES_MAKE = "courses-make"
    const val COURSES_NONE = "courses-none"
    const val COURSES_OPEN = "courses-open"
    const val COURSES_OPEN_LINK = "courses-open-link"
    const val COURSES_PAGE = "courses-page"
    const val COURSE_ABOUT = "course-about"
    const val COURSE_ADD_FILES = "course-add-files"
    const val COURSE_ADD_WORKS = "course-add-works"
    const val COURSE_ALL_DONE = "course-all-done"
    const val COURSE_CHANGE = "course-change"
    const val COURSE_DONE = "course-done"
    const val COURSE_FORM = "course-form"
    const val COURSE_GIVE = "course-give"
    const val COURSE_GIVE_HELP = "course-give-help"
    const val COURSE_GO_ON = "course-go-on"
    const val COURSE_HAND_INS = "course-hand-ins"
    const val COURSE_INCOMPLETE = "course-incomplete"
    const val COURSE_LINE = "course-line"
    const val COURSE_LINE_BACK = "course-line-back"
    const val COURSE_LINE_NEXT = "course-line-next"
    const val COURSE_LINK = "course-link"
    const val COURSE_MAKE = "course-make"
    const val COURSE_PAGE = "course-page"
    const val COURSE_PLACE = "course-place"
    const val COURSE_PROBLEM = "course-problem"
    const val COURSE_PUPIL_FILE = "course-pupil-file"
    const val COURSE_REMOVE_NO = "course-remove-no"
    const val COURSE_REMOVE_YES = "course-remove-yes"
    const val COURSE_SAVED = "course-saved"
    const val COURSE_TASKS = "course-tasks"
    const val COURSE_TASKS_HELP = "course-tasks-help"
    const val COURSE_TASKS_NONE = "course-tasks-none"
    const val COURSE_TEACHER_FILE = "course-teacher-file"
    const val COURSE_TEXT = "course-text"
    const val COURSE_TITLE = "course-title"
    const val COURSE_UNDO = "course-undo"
    const val COURSE_WORKS = "course-works"
    const val COURSE_WORKS_CLOSE = "course-works-close"
    const val COURSE_WORKS_NONE = "course-works-none"
    const val SOLVED_COURSE = "solved-course"
    const val SOLVED_COURSE_NEXT = "solved-course-next"

    fun course(key: String) = "course-$key"

    fun down(index: Int) = "course-down-$index"

    fun edit(index: Int) = "course-edit-$index"

    fun remove(key: String) = "course-remove-$key"

    fun row(index: Int) = "course-row-$index"

    fun takeOut(index: Int) = "course-take-out-$index"

    fun task(index: Int) = "course-task-$index"

    fun up(index: Int) = "course-up-$index"

    fun work(id: String) = "course-work-$id"
}

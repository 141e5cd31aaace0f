package robotran.workshop.course

import kotlinx.coroutines.CoroutineScope
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import robotran.assignments.course.courseFile
import robotran.assignments.course.isForTeachers
import robotran.assignments.course.key
import robotran.documents.StoreResult
import robotran.language.Language
import robotran.projects.Course
import robotran.projects.CourseFileResult
import robotran.projects.readCourse
import robotran.workshop.platform.KeyValueStore
import robotran.workshop.service.SerialWriteQueue

/** The result of keeping a course on the device. */
internal sealed interface KeptCourse {
    data class Kept(val key: String) : KeptCourse

    data object TooMany : KeptCourse

    data object Full : KeptCourse

    /** It is longer than a file may be. */
    data object TooLong : KeptCourse

    data class Failed(val reason: String) : KeptCourse
}

/** The courses on the device: a text for each, and another with what the pupil did in it. */
internal class CourseRepository(private val store: KeyValueStore, scope: CoroutineScope) {
    private val writes = SerialWriteQueue(scope)

    /** By key. */
    var records: Map<String, CourseRecord> = emptyMap()
        private set

    suspend fun load() {
        val keys = store.names().filter { it.startsWith(PREFIX) && it.endsWith(RECORD) }
            .map { it.removePrefix(PREFIX).removeSuffix(RECORD) }
        records = keys.mapNotNull { key -> read(key)?.let { key to it } }.toMap()
    }

    /** Keeps [course]. A course with the same key gives way; teachers' and pupils' copies have different ones. */
    suspend fun keep(course: Course, now: Long): KeptCourse {
        val key = keyOf(course)
        val before = records[key]
        if (before == null && records.size >= MAXIMUM_COURSES) return KeptCourse.TooMany
        val bytes = courseFile(course) ?: return KeptCourse.TooLong
        return when (val result = store.write(PREFIX + key, bytes.decodeToString())) {
            StoreResult.Done -> {
                write(key, (before ?: CourseRecord(course.title)).with(course, now))
                KeptCourse.Kept(key)
            }

            StoreResult.Full -> KeptCourse.Full
            StoreResult.NoAnswer -> KeptCourse.Failed("timeout")
            is StoreResult.Failed -> KeptCourse.Failed(result.reason)
        }
    }

    /** The course [key]; null if it is missing or unreadable. */
    suspend fun course(key: String): Course? =
        store.read(PREFIX + key)?.let { (readCourse(it, Language.ENGLISH) as? CourseFileResult.Success)?.course }

    /** Keeps what [change] makes of the record [key]. */
    fun update(key: String, change: (CourseRecord) -> CourseRecord) {
        val before = records[key] ?: return
        val after = change(before)
        if (after != before) write(key, after)
    }

    /** Removes the course [key]. */
    fun remove(key: String) {
        records -= key
        writes.add {
            store.remove(PREFIX + key)
            store.remove(PREFIX + key + RECORD)
        }
    }

    /** Waits until everything is stored. */
    suspend fun saveNow() = writes.finish()

    private fun write(key: String, record: CourseRecord) {
        records += key to record
        writes.add { store.write(PREFIX + key + RECORD, JSON.encodeToString(CourseRecord.serializer(), record)) }
    }

    private suspend fun read(key: String): CourseRecord? = try {
        store.read(PREFIX + key + RECORD)?.let { JSON.decodeFromString(CourseRecord.serializer(), it) }
    } catch (_: SerializationException) {
        restored(key)
    } catch (_: IllegalArgumentException) {
        restored(key)
    }

    /** A damaged record, such as after a crash, must not hide the course. */
    private suspend fun restored(key: String): CourseRecord? = course(key)?.let { CourseRecord(it.title).with(it, 0) }

    companion object {
        const val MAXIMUM_COURSES = 40
        private const val PREFIX = "course-"
        private const val RECORD = ".progress"
        private const val FOR_TEACHERS = "t"
        private val JSON = Json { ignoreUnknownKeys = true }

        fun keyOf(course: Course): String = course.key + if (course.isForTeachers) FOR_TEACHERS else ""
    }
}

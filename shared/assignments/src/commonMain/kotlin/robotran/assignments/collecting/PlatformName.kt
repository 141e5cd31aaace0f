package robotran.assignments.collecting

/**
 * What a learning platform has made of the name of a folder or file that a pupil handed in.
 *
 * @property pupil as the platform writes it.
 * @property key tells pupils of the same name apart.
 * @property rest what the pupil called it; empty for a folder that the platform has made.
 */
internal data class PlatformName(val pupil: String, val key: String, val rest: String) {
    companion object {
        /**
         * Reads names such as `Anna Meyer_12345_assignsubmission_file_prog.robo` (Moodle) and
         * `meyeranna_12345_67890_prog.robo` (Canvas); null for any other.
         */
        fun of(part: String): PlatformName? {
            MOODLE.matchEntire(part)?.destructured?.let { (pupil, number, rest) ->
                return PlatformName(pupil.trim(), "$pupil $number", rest)
            }
            CANVAS.matchEntire(part)?.destructured?.let { (pupil, number, rest) ->
                return PlatformName(pupil.trim(), "$pupil $number", rest)
            }
            return null
        }

        /**
         * What a platform wants before the name of a file that goes back to a pupil, for a hand-in from [origin]: the
         * folder in Moodle, the beginning of the file's name in Canvas; empty if no platform has named it.
         */
        fun prefixFor(origin: String): String {
            for (part in origin.split('/')) {
                val name = of(part) ?: continue
                val own = part.removeSuffix(name.rest)
                // Moodle takes files back only as files, also for a text that was typed there.
                val moodle = MOODLE_PREFIX.matchEntire(own)?.groupValues?.get(1)
                return moodle?.let { "${it}_assignsubmission_file_/" } ?: own
            }
            return ""
        }

        private val MOODLE_PREFIX = Regex("(.*)_assignsubmission_(?:file|onlinetext)_?")
        private val MOODLE = Regex("([^/]+?)_(\\d+)_assignsubmission_(?:file|onlinetext)_?(.*)")

        /** The user's number, that of the file, and `LATE` for one that came late. */
        private val CANVAS = Regex("([^/_]+)_(?:(?:LATE|late)_)?(\\d{3,})_\\d{3,}_(.+)")
    }
}

/** Whether a learning platform has made the name of a file or folder [name]. */
fun isPlatformName(name: String): Boolean = PlatformName.of(name) != null

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

        private val MOODLE = Regex("([^/]+?)_(\\d+)_assignsubmission_(?:file|onlinetext)_?(.*)")

        /** The user's number, that of the file, and `LATE` for one that came late. */
        private val CANVAS = Regex("([^/_]+)_(?:(?:LATE|late)_)?(\\d{3,})_\\d{3,}_(.+)")
    }
}

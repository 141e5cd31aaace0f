package robotran.lejoslinker

import robotran.tinyvm.diagnostic.LinkError

/** The result of [linkLejosImage]. */
sealed interface ImageResult {
    /**
     * [image] runs on a brick.
     *
     * @property warnings sentences for a learner about what may go wrong there, such as little memory for objects.
     */
    class Success(val image: LejosImage, val warnings: List<String>) : ImageResult

    /**
     * A brick cannot run the program.
     *
     * @property errors never empty; classes in the order of their numbers, each mistake once.
     */
    data class Failure(val errors: List<LinkError>) : ImageResult
}

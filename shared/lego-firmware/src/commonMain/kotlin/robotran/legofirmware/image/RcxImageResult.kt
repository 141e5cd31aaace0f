package robotran.legofirmware.image

/** The result of [readRcxImage]. */
sealed interface RcxImageResult {
    /**
     * [image] can run.
     *
     * @property warnings what is odd about the file, in its order; usually empty.
     */
    data class Success(val image: RcxImage, val warnings: List<ImageFault>) : RcxImageResult

    /** The file holds no program for an RCX. */
    data class Failure(val fault: ImageFault) : RcxImageResult
}

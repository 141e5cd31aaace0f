package robotran.world

/** What the optical distance sensor of mindsensors sees: its middle range. Lengths are in centimetres. */
object OpticalDistance {
    /** The nearest and the farthest thing whose distance it tells. Source: mindsensors, DIST-Nx-Medium. */
    const val NEAREST = 10.0
    const val FARTHEST = 80.0

    /** The width of its beam, in degrees. */
    const val BEAM = 4.0
}

package robotran.workshop.examples

/**
 * The texts that the first program had before, without the end of their last line. They are in what pupils have saved.
 * Whoever changes the first program puts its text of before here.
 */
internal val EARLIER_FIRST_PROGRAMS: Set<String> = setOf(
    """
        // Draws a square with sides of 20 centimetres.

        pen down              // from here on the robot leaves a line behind it

        repeat 4 times        // a square has four sides and four corners
          forward 20          // centimetres
          turn left 90        // degrees: a quarter of a full turn
        end

        pen up                // the drawing is done
        beep
    """,
    """
        // Draws a square, 20 cm wide.

        pen down         // begin to draw

        repeat 4 times   // it has four sides
          forward 20     // centimetres
          turn left 90   // degrees
        end

        pen up           // done drawing
        beep
    """,
    """
        // Draws a square, 20 cm wide.

        pen down  // begin to draw

        repeat 4 times  // it has four sides
          forward 20    // centimetres
          turn left 90  // degrees
        end

        pen up  // done drawing
        beep
    """,
    """
        // Draws a square, 20 cm wide.
        // Next: make it a triangle. How far
        // does it turn at each corner?

        pen down  // begin to draw

        repeat 4 times  // it has four sides
          forward 20    // centimetres
          turn left 90  // degrees
        end

        pen up  // done drawing
        beep
    """,
).map { it.trimIndent() }.toSet()

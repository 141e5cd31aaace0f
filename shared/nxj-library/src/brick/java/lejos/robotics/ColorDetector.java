package lejos.robotics;

/** Sees colours. */
public interface ColorDetector {
    /** Gives the colour as its red, green and blue. */
    Color getColor();

    /** Gives the colour as a number, such as Color.RED. */
    int getColorID();
}

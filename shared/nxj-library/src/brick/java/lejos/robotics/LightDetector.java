package lejos.robotics;

/** Measures how bright it is. */
public interface LightDetector {
    /** Gives how bright it is, 0 to 100, between what was set as dark and as bright. */
    int getLightValue();

    /** Gives how bright it is, 0 to 1023. */
    int getNormalizedLightValue();

    /** Gives what counts as bright. */
    int getHigh();

    /** Gives what counts as dark. */
    int getLow();
}

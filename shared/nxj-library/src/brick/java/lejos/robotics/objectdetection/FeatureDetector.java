package lejos.robotics.objectdetection;

/** Looks for things again and again. */
public interface FeatureDetector {
    /** Looks now, and gives what it finds, or null. */
    Feature scan();

    /** Tells a listener from now on what it finds. */
    void addListener(FeatureListener listener);

    /** Says whether to look. */
    void enableDetection(boolean on);

    /** Says whether it looks. */
    boolean isEnabled();

    /** Gives the milliseconds from one look to the next. */
    int getDelay();

    /** Sets the milliseconds from one look to the next. */
    void setDelay(int delay);
}

package lejos.robotics;

/** Measures how bright it is, and has a lamp. */
public interface LampLightDetector extends LightDetector {
    /** Switches the lamp on or off. */
    void setFloodlight(boolean on);

    /** Says whether the lamp is on. */
    boolean isFloodlightOn();

    /** Gives the colour of the lamp, a number of Color, Color.NONE if it is off. */
    int getFloodlight();

    /** Switches the lamp to a colour, and says whether it has that. */
    boolean setFloodlight(int color);
}

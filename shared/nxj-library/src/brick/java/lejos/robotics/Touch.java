package lejos.robotics;

/** Feels whether something touches it. */
public interface Touch {
    /** Says whether something touches it. */
    boolean isPressed();
}

package lejos.robotics.objectdetection;

import java.util.ArrayList;
import lejos.util.Delay;

/** Looks for things in a thread of its own; extend it and write scan. */
public abstract class FeatureDetectorAdapter implements FeatureDetector {
    private final ArrayList<FeatureListener> listeners = new ArrayList<FeatureListener>();
    private boolean isEnabled = true;
    private int delay;

    /** Makes one that looks every so many milliseconds. */
    public FeatureDetectorAdapter(int delay) {
        this.delay = delay;
        Thread looker = new Looker();
        looker.setDaemon(true);
        looker.start();
    }

    /** Looks now, and gives what it finds, or null. */
    public abstract Feature scan();

    /** Tells a listener from now on what it finds. */
    public void addListener(FeatureListener listener) {
        listeners.add(listener);
    }

    /** Says whether to look. */
    public void enableDetection(boolean enable) {
        isEnabled = enable;
    }

    /** Says whether it looks. */
    public boolean isEnabled() {
        return isEnabled;
    }

    /** Gives the milliseconds from one look to the next. */
    public int getDelay() {
        return delay;
    }

    /** Sets the milliseconds from one look to the next. */
    public void setDelay(int delay) {
        this.delay = delay;
    }

    /** Tells all listeners what was found. */
    protected void notifyListeners(Feature feature) {
        for (int index = 0; index < listeners.size(); index++) listeners.get(index).featureDetected(feature, this);
    }

    private class Looker extends Thread {
        Looker() {
        }

        public void run() {
            // The class that extends this one may not be ready yet.
            Delay.msDelay(Math.max(1, delay));
            while (true) {
                long start = System.currentTimeMillis();
                Feature found = isEnabled ? scan() : null;
                if (found != null) notifyListeners(found);
                Delay.msDelay(start + delay - System.currentTimeMillis());
                if (delay <= 0) Thread.yield();
            }
        }
    }
}

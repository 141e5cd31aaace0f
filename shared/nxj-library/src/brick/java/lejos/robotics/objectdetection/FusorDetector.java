package lejos.robotics.objectdetection;

import java.util.ArrayList;
import lejos.robotics.RangeReadings;

/** Looks by several other detectors at once. */
public class FusorDetector implements FeatureDetector, FeatureListener {
    private final ArrayList<FeatureDetector> detectors = new ArrayList<FeatureDetector>();
    private final ArrayList<FeatureListener> listeners = new ArrayList<FeatureListener>();
    private boolean isEnabled = true;
    private int delay;

    /** Makes one without detectors. */
    public FusorDetector() {
    }

    /** Adds a detector. */
    public void addDetector(FeatureDetector detector) {
        detectors.add(detector);
        detector.addListener(this);
    }

    /** Is told by the detectors; programs need not call it. */
    public void featureDetected(Feature feature, FeatureDetector detector) {
        if (!isEnabled) return;
        for (int index = 0; index < listeners.size(); index++) listeners.get(index).featureDetected(feature, this);
    }

    /** Looks now by all detectors, and gives what they find, or null. */
    public Feature scan() {
        RangeReadings all = new RangeReadings(0);
        for (FeatureDetector detector : detectors) {
            Feature found = detector.scan();
            if (found != null) all.addAll(found.getRangeReadings());
        }
        return all.isEmpty() ? null : new RangeFeature(all);
    }

    /** Tells a listener from now on what the detectors find. */
    public void addListener(FeatureListener listener) {
        listeners.add(listener);
    }

    /** Says whether to look. */
    public void enableDetection(boolean on) {
        isEnabled = on;
        for (FeatureDetector detector : detectors) detector.enableDetection(on);
    }

    /** Says whether it looks. */
    public boolean isEnabled() {
        return isEnabled;
    }

    /** Gives the milliseconds from one look to the next. */
    public int getDelay() {
        return delay;
    }

    /** Sets the milliseconds from one look to the next, of all detectors. */
    public void setDelay(int delay) {
        this.delay = delay;
        for (FeatureDetector detector : detectors) detector.setDelay(delay);
    }
}

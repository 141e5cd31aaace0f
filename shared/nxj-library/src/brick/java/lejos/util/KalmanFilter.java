package lejos.util;

/**
 * Estimates the state of something that moves, from what it is told to do and from what is measured, as matrices.
 *
 * <p>State, control and measurement are columns. Each update first predicts the state: the transition times the state
 * plus the control matrix times the control. Then it corrects the state by the measurement.
 */
public class KalmanFilter {
    private final Matrix transition;
    private final Matrix control;
    private final Matrix observation;
    private final Matrix measurementNoise;
    private final Matrix motionNoise;
    private final Matrix transitionTurned;
    private final Matrix observationTurned;

    private Matrix mean;
    private Matrix covariance;
    private Matrix identity;
    private Matrix predictedMean;
    private Matrix predictedCovariance;
    private Matrix gain;

    /** Makes one of the matrices of transition, control and observation, and of the noise of measuring and moving. */
    public KalmanFilter(Matrix a, Matrix b, Matrix c, Matrix q, Matrix r) {
        transition = a;
        control = b;
        observation = c;
        measurementNoise = q;
        motionNoise = r;
        transitionTurned = a.transpose();
        observationTurned = c.transpose();
    }

    /** Sets the state and its covariance. */
    public void setState(Matrix mean, Matrix covariance) {
        this.mean = mean;
        this.covariance = covariance;
        int size = mean.getRowDimension();
        identity = Matrix.identity(size, size);
    }

    /** Predicts the state after a control, and corrects it by a measurement. */
    public void update(Matrix control, Matrix measurement) {
        predictedMean = transition.times(mean).plus(this.control.times(control));
        predictedCovariance = transition.times(covariance).times(transitionTurned).plus(motionNoise);
        Matrix innovation = observation.times(predictedCovariance).times(observationTurned).plus(measurementNoise);
        gain = predictedCovariance.times(observationTurned).times(innovation.inverse());
        Matrix surprise = measurement.minus(observation.times(predictedMean));
        mean = predictedMean.plus(gain.times(surprise));
        covariance = identity.minus(gain.times(observation)).times(predictedCovariance);
    }

    /** Gives the state. */
    public Matrix getMean() {
        return mean;
    }

    /** Gives the covariance of the state. */
    public Matrix getCovariance() {
        return covariance;
    }

    /** Gives the state as it was predicted before the measurement. */
    public Matrix getPredictedMean() {
        return predictedMean;
    }

    /** Gives the covariance as it was predicted before the measurement. */
    public Matrix getPredictedCovariance() {
        return predictedCovariance;
    }

    /** Gives how much the last measurement counted. */
    public Matrix getGain() {
        return gain;
    }
}

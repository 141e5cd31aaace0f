import lejos.util.KalmanFilter;
import lejos.util.Matrix;

/** A Kalman filter follows a robot that drives towards a wall, and trusts its sonar more and more. */
public class Estimates {
    static Matrix of(double number) {
        return new Matrix(1, 1, number);
    }

    public static void main(String[] arguments) {
        KalmanFilter filter = new KalmanFilter(of(1), of(0.5), of(1), of(4), of(1));
        filter.setState(of(100), of(15));
        filter.update(of(-20), of(94));
        System.out.println(filter.getPredictedMean().get(0, 0) + " " + filter.getPredictedCovariance().get(0, 0)); // expect 90.0 16.0
        System.out.println(Math.round(1000 * filter.getGain().get(0, 0))); // expect 800
        System.out.println(Math.round(1000 * filter.getMean().get(0, 0))); // expect 93200
        System.out.println(Math.round(1000 * filter.getCovariance().get(0, 0))); // expect 3200
        // Two numbers: where it is, and how fast.
        KalmanFilter two = new KalmanFilter(new Matrix(new double[][] {{1, 1}, {0, 1}}), new Matrix(2, 1),
            new Matrix(new double[][] {{1, 0}}), of(1), Matrix.identity(2, 2).times(0.25));
        two.setState(new Matrix(2, 1), Matrix.identity(2, 2));
        for (int i = 1; i <= 20; i++) two.update(of(0), of(3 * i));
        System.out.println(Math.round(two.getMean().get(0, 0)) + " " + Math.round(two.getMean().get(1, 0))); // expect 60 3
    }
}

// Measures the light ten times, half a second apart, and shows the
// average. A timer calls timedOut again and again.
// Next: show the darkest and the brightest.

import josx.platform.rcx.LCD;
import josx.platform.rcx.Sensor;
import josx.util.Timer;
import josx.util.TimerListener;

public class DataLogger implements TimerListener {
    private final int[] values = new int[10];
    private int count;

    public static void main(String[] args) throws InterruptedException {
        Sensor.S2.activate();
        DataLogger logger = new DataLogger();
        new Timer(500, logger).start();
        logger.awaitAll();
        LCD.showNumber(logger.average());
        Thread.sleep(2000);
        System.exit(0); // or the timer would go on
    }

    public synchronized void timedOut() {
        if (count == values.length) return;
        values[count] = Sensor.S2.readValue();
        LCD.showNumber(values[count]);
        count++;
        notifyAll();
    }

    synchronized void awaitAll() throws InterruptedException { // not private: a brick would not lock it
        while (count < values.length) wait();
    }

    private int average() {
        int sum = 0;
        for (int index = 0; index < count; index++) sum += values[index];
        return sum / count;
    }
}

// Measures how warm it is, shows whole degrees, and warns when it is too cold.

import josx.platform.rcx.LCD;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.SensorConstants;
import josx.platform.rcx.Sound;

class Thermometer {
    static final int TOO_COLD = 5; // degrees Celsius

    public static void main(String[] args) throws InterruptedException {
        Sensor.S1.setTypeAndMode(SensorConstants.SENSOR_TYPE_TEMP, SensorConstants.SENSOR_MODE_DEGC);
        Thread.sleep(100); // until it has measured
        int tenths = Sensor.S1.readValue();
        int degrees = (tenths + 5) / 10; // rounded
        LCD.showNumber(degrees);
        if (degrees < TOO_COLD) {
            for (int times = 0; times < 2; times++) {
                Sound.playTone(220, 40);
                Thread.sleep(800);
            }
        }
        Thread.sleep(1000);
    }
}

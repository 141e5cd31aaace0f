public class TimesOfDay {
    private static final long DAY = 24L * 60 * 60 * 1000;
    private final long milliseconds;

    TimesOfDay(long milliseconds) {
        this.milliseconds = (milliseconds % DAY + DAY) % DAY;
    }

    TimesOfDay(int hours, int minutes, int seconds) {
        this(((hours * 60L + minutes) * 60 + seconds) * 1000);
    }

    private static String two(long number) {
        return (number < 10 ? "0" : "") + number;
    }

    TimesOfDay plus(long amount) {
        return new TimesOfDay(milliseconds + amount);
    }

    @Override
    public String toString() {
        long seconds = milliseconds / 1000;
        return two(seconds / 3600) + ":" + two(seconds / 60 % 60) + ":" + two(seconds % 60) + "." + milliseconds % 1000;
    }

    static int dayOfTheWeek(int year, int month, int day) {
        int shift = (14 - month) / 12;
        int y = year - shift;
        int m = month + 12 * shift - 2;
        return (day + y + y / 4 - y / 100 + y / 400 + 31 * m / 12) % 7;
    }

    public static void main(String[] arguments) {
        TimesOfDay late = new TimesOfDay(23, 59, 58);
        System.out.println(late + " " + late.plus(2500) + " " + late.plus(-DAY * 3 - 1));
        System.out.println(new TimesOfDay(Long.MAX_VALUE) + " " + new TimesOfDay(Integer.MIN_VALUE));
        System.out.println(dayOfTheWeek(2006, 7, 1) + " " + dayOfTheWeek(2000, 2, 29) + " " + dayOfTheWeek(1998, 1, 1));
        // expect 23:59:58.0 00:00:00.500 23:59:57.999
        // expect 07:12:55.807 03:28:36.352
        // expect 6 2 4
    }
}

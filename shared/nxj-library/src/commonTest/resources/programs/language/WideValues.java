public class WideValues {
    static long counter = 1L << 40;
    static double total;
    long own = -3;
    double part = 0.25;
    int after = 9;

    static long mixed(int a, long b, double c, byte d, long e) {
        return a + b * (long) c - d + e;
    }

    static double half(long value) {
        return value / 2.0;
    }

    long add(long value) {
        own += value;
        return own++;
    }

    static long fibonacci(int n) {
        return n < 2 ? n : fibonacci(n - 1) + fibonacci(n - 2);
    }

    public static void main(String[] arguments) {
        System.out.println(mixed(1, 2L, 3.9, (byte) 4, 1L << 35)); // expect 34359738371
        System.out.println(half(counter + 1)); // expect 5.497558138885E11
        WideValues values = new WideValues();
        System.out.println(values.add(10) + " " + values.own + " " + values.after); // expect 7 8 9
        values.part *= 3;
        values.part -= values.own;
        System.out.println(values.part + " " + values.after); // expect -7.25 9
        counter++;
        ++counter;
        counter -= 2;
        System.out.println(counter-- + " " + counter); // expect 1099511627776 1099511627775
        total += counter;
        total++;
        System.out.println(total); // expect 1.099511627776E12
        long[] array = {5, 6, 7};
        int place = 0;
        array[place++] += array[place] *= 10;
        System.out.println(array[0] + " " + array[1] + " " + place); // expect 65 60 1
        double[] reals = {1, 2};
        reals[1] = reals[0] = 8;
        System.out.println(reals[1]++ + ++reals[1]); // expect 18.0
        long first;
        long second;
        first = second = 77;
        System.out.println(first + second); // expect 154
        System.out.println(fibonacci(20)); // expect 6765
        long chosen = first > second ? first : array[2];
        System.out.println(chosen); // expect 7
        System.out.println(first < second || 2.5 >= total ? "yes" : "no"); // expect no
        values.own = array[1] = 3;
        System.out.println(values.own); // expect 3
        new WideValues().add(3);
        long ignored = values.own++ + values.own--;
        System.out.println(ignored + " " + values.own); // expect 7 3
    }
}

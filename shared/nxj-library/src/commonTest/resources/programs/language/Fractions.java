public class Fractions {
    private final long above;
    private final long below;

    Fractions(long above, long below) {
        if (below == 0) throw new ArithmeticException("no fraction");
        long divisor = common(Math.abs(above), Math.abs(below));
        long sign = below < 0 ? -1 : 1;
        this.above = sign * above / divisor;
        this.below = sign * below / divisor;
    }

    static long common(long a, long b) {
        while (b != 0) {
            long rest = a % b;
            a = b;
            b = rest;
        }
        return a == 0 ? 1 : a;
    }

    Fractions plus(Fractions other) {
        return new Fractions(above * other.below + other.above * below, below * other.below);
    }

    Fractions times(Fractions other) {
        return new Fractions(above * other.above, below * other.below);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Fractions && above == ((Fractions) other).above && below == ((Fractions) other).below;
    }

    @Override
    public int hashCode() {
        return (int) (31 * above + below);
    }

    @Override
    public String toString() {
        return above + "/" + below;
    }

    public static void main(String[] arguments) {
        Fractions sum = new Fractions(0, 1);
        for (int n = 1; n <= 20; n++) sum = sum.plus(new Fractions(n % 2 == 0 ? -1 : 1, n));
        System.out.println(sum);
        System.out.println(new Fractions(6, -8).times(new Fractions(-4, 9)));
        System.out.println(new Fractions(2, 4).equals(new Fractions(-1, -2)) + " " + new Fractions(2, 4).hashCode());
        try {
            new Fractions(1, 0);
        } catch (ArithmeticException wrong) {
            System.out.println(wrong.getMessage());
        }
        // expect 155685007/232792560
        // expect 1/3
        // expect true 33
        // expect no fraction
    }
}

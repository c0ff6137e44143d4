#!/usr/bin/env python3
"""ssim_scikit.py EXPECTED ACTUAL WIDTH HEIGHT: the seconds that scikit-image takes for SSIM as the paper has it, and the
score, of two files of RGB bytes."""
import sys
import time

import numpy
from skimage.metrics import structural_similarity

width, height = map(int, sys.argv[3:])
pictures = [numpy.fromfile(path, dtype=numpy.uint8).reshape(height, width, 3) for path in sys.argv[1:3]]
start = time.perf_counter()
score = structural_similarity(*pictures, channel_axis=2, gaussian_weights=True, sigma=1.5, use_sample_covariance=False,
                              data_range=255)
print(time.perf_counter() - start, score)
